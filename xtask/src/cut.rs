//! Scenes whose phases end after a few steps: the beginning of a run that takes long, of every phase a piece.

/// Words of the command line that end each phase of a scene, given by its text, after `steps` steps, or iterations where it relaxes.
///
/// Gravity is there at once: a ramp that is cut off would go on as a jump, which the guard of a run takes for energy from nowhere.
pub fn words(scene: &str, steps: usize) -> Vec<String> {
    let phases = scene.split("\n[[phases]]").skip(1);
    let mut words = Vec::new();
    let mut set = |change: String| words.extend(["--set".to_owned(), change]);
    for (k, phase) in phases.enumerate() {
        set(format!("phases.{k}.until.steps={steps}"));
        let own = phase.split("\n[[").next().unwrap_or("");
        if own.lines().any(|line| line.trim_start().starts_with("gravity_ramp")) {
            set(format!("phases.{k}.gravity_ramp=0 s"));
        }
    }
    words
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_phase_is_cut_and_ramps_go() {
        let scene = "a\n[[phases]]\nname = \"x\"\nuntil.time = \"1 s\"\n[[outputs]]\ngravity_ramp = 1\n[[phases]]\ngravity_ramp = \"2 s\"\n";
        let words = words(scene, 7);
        let changes: Vec<&str> = words.iter().skip(1).step_by(2).map(String::as_str).collect();
        let due = ["phases.0.until.steps=7", "phases.1.until.steps=7", "phases.1.gravity_ramp=0 s"];
        assert_eq!(changes, due);
        assert!(words.iter().step_by(2).all(|word| word == "--set"));
    }
}
