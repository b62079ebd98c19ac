//! Holes that leave the rock.

use super::*;

#[test]
fn the_length_of_a_hole_in_the_air_is_told() {
    let told = |line: &str, more: &str| {
        let hole = format!(
            "[[blocks]]\nname = \"rock\"\nmaterial = \"rock\"\ngrid.box = {{ size = [\"3 m\", \"3 m\", \"8 m\"], cell = \"1 m\", corner = [\"0 m\", \"0 m\", \"-8 m\"] }}\n{more}\n[sources.hole.pressure_cavity]\nline = {{ from = {line} }}\npressure.constant = \"1 MPa\"\n"
        );
        let (_, model) = solid(&hole);
        let of_hole = model.warnings.iter().filter(|w| w.code == "source.air");
        of_hole.map(|w| w.message.clone()).collect::<Vec<_>>()
    };
    let inside = r#"["1.5 m", "1.5 m", "0 m"], to = ["1.5 m", "1.5 m", "-8 m"]"#;
    assert!(told(inside, "").is_empty());
    let long = r#"["1.5 m", "1.5 m", "1 m"], to = ["1.5 m", "1.5 m", "-19 m"]"#;
    assert_eq!(told(long, ""), ["12 m of the 20 m of `hole` lie outside all blocks"]);
    // Oblique, out of the side at x = 3 m: a third of 3 sqrt(2) m.
    let side = r#"["1 m", "1.5 m", "-2.5 m"], to = ["4 m", "1.5 m", "-5.5 m"]"#;
    assert_eq!(told(side, ""), ["1.414214 m of the 4.242641 m of `hole` lie outside all blocks"]);
    // A gap between two blocks.
    let far = "[[blocks]]\nname = \"far\"\nmaterial = \"rock\"\nbrick = { size = [\"3 m\", \"3 m\", \"1 m\"], corner = [\"0 m\", \"0 m\", \"-10 m\"] }";
    let gap = r#"["1.5 m", "1.5 m", "-6 m"], to = ["1.5 m", "1.5 m", "-10 m"]"#;
    assert_eq!(told(gap, far), ["1 m of the 4 m of `hole` lie outside all blocks"]);
}
