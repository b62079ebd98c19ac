use std::path::PathBuf;

use super::{Answer, BETWEEN, Confining, Rules, StrengthError, Test, strength};

fn rules(test: Test) -> Rules {
    Rules {
        test,
        load: "load".to_owned(),
        area: None,
        strain: None,
        length: None,
        confining: None,
        between: BETWEEN,
    }
}

fn near(value: f64, expected: f64) {
    assert!((value - expected).abs() <= 1e-9 * expected.abs(), "{value}, not {expected}");
}

/// A folder with one run for each text of histories.
fn runs(texts: &[String], rules: &Rules) -> Result<Answer, StrengthError> {
    let dir = tempfile::tempdir().unwrap();
    for (k, text) in texts.iter().enumerate() {
        let run = dir.path().join(format!("{k}.run"));
        std::fs::create_dir(&run).unwrap();
        std::fs::write(run.join("histories.csv"), text).unwrap();
    }
    strength(&[dir.path().to_owned()], rules)
}

/// A specimen of 20 GPa that fails at `peak` (Pa) and keeps a tenth of it; loads over 2 m2, shortening over 0.5 m, both negative.
fn compressed(peak: f64, confining: f64) -> String {
    let mut text = "step,time [s],load [N],short [m],side [Pa]\n".to_owned();
    for k in 0..200 {
        let strain = 1e-4 * f64::from(k);
        let stress = if 20e9 * strain <= peak { 20e9 * strain } else { 0.1 * peak };
        // Some samples were not due.
        let side = if k % 60 == 59 { String::new() } else { (-confining).to_string() };
        text.push_str(&format!("{k},{k},{},{},{side}\n", -2.0 * stress, -0.5 * strain));
    }
    text
}

#[test]
fn modulus_strength_and_the_line_of_mohr_and_coulomb() {
    // phi = 30 deg, c = 20 MPa: s1 = 2 c sqrt(3) + 3 s3.
    let alone = 40e6 * 3f64.sqrt();
    let sides = [0.0, 5e6, 10e6];
    // A whole number of samples before failure, so that the peak is met: rounded down to 2 MPa.
    let step = |s: f64| (s / 2e6).floor() * 2e6;
    let texts = sides.map(|side| compressed(step(alone + 3.0 * side) + 1.0, side));
    let asked = Rules {
        area: Some(2.0),
        strain: Some("short".to_owned()),
        length: Some(0.5),
        confining: Some(Confining::History("side".to_owned())),
        ..rules(Test::Axial)
    };
    let answer = runs(&texts, &asked).unwrap();
    for (test, side) in answer.tests.iter().zip(sides) {
        near(test.peak, step(alone + 3.0 * side));
        near(test.modulus.unwrap(), 20e9);
        near(test.strain_at_peak.unwrap(), test.peak / 20e9);
        assert!((test.residual - 0.1 * test.peak).abs() < 1.0 && !test.at_end);
        assert!((test.confining.unwrap() - side).abs() < 1e-6 && test.fit.unwrap() > 0.999_999);
    }
    // 68, 84, 98 MPa: within what the rounding makes of 30 deg and 20 MPa.
    let line = answer.envelope.unwrap();
    assert!((line.friction.value - 30.0).abs() < 2.0 * line.friction.error.unwrap(), "{line:?}");
    assert!((line.cohesion.value - 20e6).abs() < 2.0 * line.cohesion.error.unwrap(), "{line:?}");
    assert!(answer.words().contains("friction angle") && answer.table().unwrap().len() > 100);
}

#[test]
fn shear_tests_and_disks() {
    // tau = 1 MPa + s tan(35 deg): without scatter the error is nothing.
    let slope = 35f64.to_radians().tan();
    let sheared = |normal: f64| {
        let peak = 1e6 + normal * slope;
        format!(
            "step,time [s],load [Pa],normal [Pa]\n0,0,0,{normal}\n1,1,{peak},{normal}\n2,2,{},{normal}\n",
            0.5 * peak
        )
    };
    let texts = [2e6, 4e6, 8e6].map(sheared);
    let normal = Some(Confining::read("normal"));
    let answer = runs(&texts, &Rules { confining: normal, ..rules(Test::Shear) }).unwrap();
    let line = answer.envelope.unwrap();
    near(line.cohesion.value, 1e6);
    near(line.friction.value, 35.0);
    assert!(line.friction.error.unwrap() < 1e-6 && line.cohesion.error.unwrap() < 1.0);
    // One test, and two: no line, and no error.
    let normal = Some(Confining::read("2 MPa"));
    let one = Rules { confining: normal, ..rules(Test::Shear) };
    assert_eq!(runs(&texts[..1], &one).unwrap().envelope, None);
    // A disk of 54 mm by 27 mm under 20 kN: 2 P/(pi D t).
    let disk = Test::Disk { diameter: 0.054, thickness: Some(0.027) };
    let loaded = "step,time [s],load [N]\n0,0,0\n1,1,-20000\n".to_owned();
    let answer = runs(std::slice::from_ref(&loaded), &rules(disk)).unwrap();
    near(answer.tests[0].peak, 2.0 * 20e3 / (std::f64::consts::PI * 0.054 * 0.027));
    assert!(answer.tests[0].at_end && answer.words().contains("still rising"));
    let flat = Test::Disk { diameter: 0.054, thickness: None };
    near(runs(&[loaded], &rules(flat)).unwrap().tests[0].peak, answer.tests[0].peak * 0.027);
}

#[test]
fn what_cannot_be_read_is_told() {
    let text = "step,time [s],load [N],rest [N],none [N]\n0,0,1,0,\n1,1,2,0,\n".to_owned();
    let ask = |load: &str| {
        runs(std::slice::from_ref(&text), &Rules { load: load.to_owned(), ..rules(Test::Axial) })
    };
    assert!(ask("laod").unwrap_err().to_string().contains("load"));
    assert!(matches!(ask("rest"), Err(StrengthError::Zero { .. })));
    assert!(matches!(ask("none"), Err(StrengthError::Empty { .. })));
    assert!(matches!(runs(&[], &rules(Test::Axial)), Err(StrengthError::NoRun(_))));
    let no = strength(&[PathBuf::from("/nowhere")], &rules(Test::Axial));
    assert!(matches!(no, Err(StrengthError::NoRun(_))));
    for wrong in [
        Rules { between: [0.5, 0.2], ..rules(Test::Axial) },
        Rules { area: Some(0.0), ..rules(Test::Axial) },
        Rules { length: Some(f64::NAN), ..rules(Test::Axial) },
    ] {
        assert!(matches!(runs(std::slice::from_ref(&text), &wrong), Err(StrengthError::Number(_))));
    }
}

#[test]
fn histories_in_other_units_are_refused() {
    let text = compressed(40e6, 5e6);
    let told = |rules: Rules| runs(std::slice::from_ref(&text), &rules).unwrap_err().to_string();
    let no_area = told(rules(Test::Axial));
    assert!(no_area.contains("`load` is in N, but a stress is in Pa"), "{no_area}");
    let short = Some("short".to_owned());
    let loaded = || Rules { area: Some(2.0), ..rules(Test::Axial) };
    let no_length = told(Rules { strain: short.clone(), ..loaded() });
    assert!(
        no_length.contains("`short` is in m, but a strain is in a plain number"),
        "{no_length}"
    );
    let side = told(Rules { load: "side".to_owned(), ..loaded() });
    assert!(side.contains("`side` is"), "{side}");
    // A way over a length, and a strain as it is.
    assert!(
        runs(std::slice::from_ref(&text), &Rules { strain: short, length: Some(0.5), ..loaded() })
            .is_ok()
    );
}
