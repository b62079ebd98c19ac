//! Conditions that have lost a part of their faces to later ones, in words.

use super::engine::View;

/// A sentence for every two conditions that mean the same faces. A condition left without any is no model.
pub(super) fn words(view: &View<'_>) -> Vec<String> {
    let Some(view) = view.spatial() else {
        return Vec::new();
    };
    let name = |index: u16| &view.world.setup.boundaries[usize::from(index)].name;
    let lost = view.world.overruled.iter();
    lost.map(|lost| {
        let [earlier, later] = lost.boundaries.map(name);
        format!(
            "boundary `{later}` overrides `{earlier}` on {} of its {} faces: a face has one condition, the last one given; if this is not intended, \
             select other faces",
            lost.faces, lost.of
        )
    })
    .collect()
}

#[cfg(test)]
mod tests {
    use crate::exec::Exec;
    use crate::run::forecast::forecast;
    use crate::run::scene::Scene;
    use crate::scenario::Source;

    /// A wall of 4 x 4 bricks that absorbs waves on its left, and is pushed there from `low` upwards.
    fn wall(low: &str) -> Scene {
        let text = format!(
            "riprap = 1\ntitle = \"t\"\n[space.spatial]\ngravity = \"0 m/s2\"\n\
             [materials.rock]\ndensity = \"2700 kg/m3\"\nyoung = \"50 GPa\"\npoisson = 0\n\
             [interfaces.default]\nelastic = true\n\
             [[blocks]]\nname = \"wall\"\nmaterial = \"rock\"\n\
             grid.box = {{ size = [\"4 m\", \"4 m\", \"1 m\"], cell = \"1 m\" }}\n\
             [[boundaries]]\nname = \"absorb\"\non.plane = \"x-min\"\nviscous = {{}}\n\
             [[boundaries]]\nname = \"push\"\n\
             on.box = {{ min = [\"-0.1 m\", \"{low}\", \"-1 m\"], max = [\"0.1 m\", \"4.1 m\", \"2 m\"] }}\n\
             on.side = \"x-min\"\npressure.value = \"1 MPa\"\n\
             [[phases]]\nname = \"run\"\nuntil.time = \"8 ms\"\n"
        );
        Scene::parse(Source::new("t.toml", text), ".".into(), &[]).unwrap()
    }

    #[test]
    fn a_condition_that_loses_a_part_of_its_faces_is_told() {
        let scene = wall("1.9 m");
        let prepared = scene.prepare(&scene.plain()).unwrap();
        let job = prepared.clone().job();
        let told = forecast(&job.setup, &job.plan).unwrap().warnings;
        let wanted = "boundary `push` overrides `absorb` on 2 of its 4 faces";
        assert!(told.iter().any(|w| w.starts_with(wanted)), "{told:?}");
        // At the end of a run too.
        let simulation = prepared.simulation(Exec::serial()).unwrap();
        let told = simulation.warnings();
        assert!(told.iter().any(|w| w.starts_with(wanted)), "{told:?}");
        // One that has lost all its faces is an error as before.
        let job = |scene: &Scene| scene.prepare(&scene.plain()).unwrap().job();
        let whole = job(&wall("-0.1 m"));
        let error = forecast(&whole.setup, &whole.plan).unwrap_err();
        assert!(error.to_string().contains("has no effect"), "{error}");
    }
}
