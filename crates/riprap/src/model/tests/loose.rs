//! Blocks that touch nothing where they probably should are reported; falling ones are a scene like any other.

use super::*;

/// What is reported for loose blocks, code by code.
fn told(text: &str) -> Vec<(&'static str, String)> {
    let parsed = parse(Source::new("t.toml", text)).unwrap_or_else(|error| panic!("{error}"));
    let model = build(&parsed, "default", &[]).unwrap_or_else(|error| panic!("{error}"));
    let of = ["model.falls", "model.gap"];
    let told = model.warnings.iter().filter(|w| of.contains(&w.code));
    told.map(|w| (w.code, w.message.clone())).collect()
}

/// A floor, a pile of three bricks on it, and `more`, in the plane.
fn plane(more: &str, phase: &str) -> String {
    let rectangle = |name: &str, size: &str, corner: &str| {
        format!(
            "[[blocks]]\nname = \"{name}\"\nmaterial = \"rock\"\nrectangle = {{ size = {size}, corner = {corner} }}\n"
        )
    };
    let pile: String = (0..3)
        .map(|k| {
            let corner = format!("[\"0 m\", \"{k} m\"]");
            rectangle(&format!("b{k}"), "[\"1 m\", \"1 m\"]", &corner)
        })
        .collect();
    let floor = rectangle("floor", "[\"9 m\", \"1 m\"]", "[\"-1 m\", \"-1 m\"]");
    format!(
        "{HEAD}{floor}{pile}{more}[[supports]]\non.block = \"floor\"\nfixed = {{}}\n\
         [[phases]]\nname = \"go\"\n{phase}\nuntil = {{ time = \"1 s\" }}\n"
    )
}

fn brick(x: &str, y: &str, keys: &str) -> String {
    format!(
        "[[blocks]]\nname = \"loose\"\nmaterial = \"rock\"\n\
         rectangle = {{ size = [\"1 m\", \"1 m\"], corner = [\"{x}\", \"{y}\"] }}\n{keys}\n"
    )
}

const STATIC: &str = "kind = \"static\"";

#[test]
fn a_gap_that_is_a_slip_is_told() {
    let slip = plane(&brick("0 m", "3.002 m", ""), "");
    let [(code, message)] = &told(&slip)[..] else {
        panic!("{:?}", told(&slip));
    };
    assert_eq!(*code, "model.gap");
    assert_eq!(
        message,
        "block `loose` touches nothing at the start, and `loose` is 0.002 m away from `b2`"
    );
    // One that touches, one that falls, one that is thrown.
    for quiet in [
        brick("0 m", "3 m", ""),
        brick("0 m", "3.5 m", ""),
        brick("0 m", "3.002 m", "velocity = [\"0 m/s\", \"-1 m/s\"]"),
    ] {
        assert_eq!(told(&plane(&quiet, "")), [], "{quiet}");
    }
}

#[test]
fn blocks_that_hang_in_the_air_of_a_static_phase_are_told() {
    let high = told(&plane(&brick("0 m", "3.5 m", ""), STATIC));
    assert_eq!(
        high,
        [(
            "model.gap",
            "block `loose` touches nothing at the start of the static phase `go`".to_owned()
        )]
    );
    let beside = told(&plane(&brick("20 m", "3.5 m", ""), STATIC));
    assert_eq!(
        beside,
        [(
            "model.falls",
            "block `loose` touches nothing and has nothing below; the static phase `go` cannot reach equilibrium"
                .to_owned()
        )]
    );
    // In true time it is a fall; what is held or loaded does not fall.
    let held = "[[supports]]\non.block = \"loose\"\nfixed = {}\n";
    let loaded = "[[loads]]\non.block = \"loose\"\npoint = { force = [\"0 N/m\", \"20 kN/m\"] }\n";
    assert_eq!(told(&plane(&brick("20 m", "3.5 m", ""), "")), []);
    for more in [held, loaded] {
        let held = format!("{}{more}", brick("20 m", "3.5 m", ""));
        assert_eq!(told(&plane(&held, STATIC)), [], "{more}");
    }
}

#[test]
fn what_the_first_phase_fixes_does_not_fall() {
    let fixed = format!("{STATIC}\nfix = [\"loose\"]");
    assert_eq!(told(&plane(&brick("20 m", "3.5 m", ""), &fixed)), []);
}

/// In the plane blocks have no width across it.
#[test]
fn the_gap_is_held_against_the_width_of_wide_blocks_too() {
    let wide = |corner: &str, name: &str| {
        format!(
            "[[blocks]]\nname = \"{name}\"\nmaterial = \"rock\"\nrectangle = {{ size = [\"10 m\", \"10 m\"], corner = {corner} }}\n"
        )
    };
    let two = wide("[\"30 m\", \"0 m\"]", "w") + &wide("[\"30 m\", \"10.05 m\"]", "on_top_of_it");
    let codes: Vec<&str> = told(&plane(&two, "")).iter().map(|(code, _)| *code).collect();
    assert_eq!(codes, ["model.gap"]);
}

#[test]
fn a_heap_that_is_poured_is_quiet() {
    let drop = |count: u32| {
        let copies = format!("copies = {{ count = {count}, step = [\"0 m\", \"1.5 m\"] }}");
        told(&plane(&brick("3 m", "1 m", &copies), STATIC))
    };
    assert_eq!(drop(12), []);
    assert_eq!(drop(2).len(), 1);
}

#[test]
fn the_same_in_space() {
    let brick = |name: &str, corner: &str| {
        format!(
            "[[blocks]]\nname = \"{name}\"\nmaterial = \"rock\"\n\
             brick = {{ size = [\"1 m\", \"1 m\", \"1 m\"], corner = {corner} }}\n"
        )
    };
    let scene = |corner: &str, phase: &str| {
        let pile =
            brick("a", "[\"0 m\", \"0 m\", \"1 m\"]") + &brick("b", "[\"0 m\", \"0 m\", \"2 m\"]");
        told(&format!(
            "{SPACE}{}{pile}{}[[supports]]\non.block = \"floor\"\nfixed = {{}}\n\
             [[phases]]\nname = \"go\"\n{phase}\nuntil = {{ time = \"1 s\" }}\n",
            brick("floor", "[\"0 m\", \"0 m\", \"0 m\"]"),
            brick("loose", corner)
        ))
    };
    let codes = |corner: &str, phase: &str| -> Vec<&str> {
        scene(corner, phase).iter().map(|(code, _)| *code).collect()
    };
    assert_eq!(codes("[\"0 m\", \"0 m\", \"3.001 m\"]", ""), ["model.gap"]);
    assert_eq!(codes("[\"0 m\", \"0 m\", \"3 m\"]", ""), [""; 0]);
    assert_eq!(codes("[\"0 m\", \"0 m\", \"4 m\"]", STATIC), ["model.gap"]);
    assert_eq!(codes("[\"5 m\", \"0 m\", \"4 m\"]", STATIC), ["model.falls"]);
    assert_eq!(codes("[\"5 m\", \"0 m\", \"4 m\"]", ""), [""; 0]);
    // Boundaries hold what they may touch, and nothing else.
    let bounded = |plane: &str| {
        let text = format!(
            "{SPACE}{}{}[[boundaries]]\nname = \"edge\"\non.plane = \"{plane}\"\nheld = {{}}\n\
             [[phases]]\nname = \"go\"\n{STATIC}\nuntil = {{ time = \"1 s\" }}\n",
            brick("floor", "[\"0 m\", \"0 m\", \"0 m\"]"),
            brick("loose", "[\"5 m\", \"0 m\", \"4 m\"]")
        );
        let told = told(&text);
        ["floor", "loose"]
            .map(|name| told.iter().any(|(_, words)| words.contains(&format!("`{name}`"))))
    };
    assert_eq!(bounded("z-min"), [false, true]);
    assert_eq!(bounded("x-max"), [true, false]);
    // Held by its nodes.
    let text = format!(
        "{SPACE}{}{}mechanics.deformable = {{}}\n[[supports]]\non.block = \"floor\"\nfixed = {{}}\n\
         [[supports]]\non.nodes = {{ min = [\"5 m\", \"0 m\", \"4 m\"], max = [\"5 m\", \"1 m\", \"5 m\"] }}\nfixed = {{}}\n\
         [[phases]]\nname = \"go\"\n{STATIC}\nuntil = {{ time = \"1 s\" }}\n",
        brick("floor", "[\"0 m\", \"0 m\", \"0 m\"]"),
        brick("loose", "[\"5 m\", \"0 m\", \"4 m\"]")
    );
    assert_eq!(told(&text), []);
}
