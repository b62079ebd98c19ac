//! Contact laws of code.

use std::path::Path;

use super::{live, on, speed, text, told};
use crate::record::manifest::{Ended, Manifest};
use crate::run::drive::{Control, DriveError, Pause};
use crate::run::job::{JobError, Live};
use crate::run::simulation::{ContactLaw, Contacts};

/// A traction against the relative velocity, Pa s/m.
#[derive(Debug)]
struct Damper(f64);

impl ContactLaw for Damper {
    fn tractions(&mut self, contacts: &mut Contacts) -> Result<Vec<[f64; 3]>, String> {
        Ok(contacts.velocity.iter().map(|v| v.map(|v| self.0 * v)).collect())
    }
}

/// A spring along the contact that breaks at a stress (Pa); it remembers whether it has.
#[derive(Debug)]
struct Glue {
    stiffness: f64,
    strength: f64,
}

impl ContactLaw for Glue {
    fn memory(&self) -> usize {
        1
    }

    fn tractions(&mut self, contacts: &mut Contacts) -> Result<Vec<[f64; 3]>, String> {
        let mut all = Vec::new();
        for (k, (u, n)) in contacts.displacement.iter().zip(&contacts.normal).enumerate() {
            let across: f64 = u.iter().zip(n).map(|(u, n)| u * n).sum();
            let along = [0, 1, 2].map(|k| self.stiffness * (u[k] - across * n[k]));
            if along.iter().map(|t| t * t).sum::<f64>().sqrt() > self.strength {
                contacts.memory[k] = 1.0;
            }
            all.push(if contacts.memory[k] > 0.0 { [0.0; 3] } else { along });
        }
        Ok(all)
    }
}

/// Fails from a step on, or gives what is no number.
#[derive(Debug)]
struct Bad {
    after: f64,
    number: bool,
}

impl ContactLaw for Bad {
    fn tractions(&mut self, contacts: &mut Contacts) -> Result<Vec<[f64; 3]>, String> {
        match (contacts.time > self.after, self.number) {
            (true, false) => Err("no more".to_owned()),
            (true, true) => Ok(vec![[f64::NAN; 3]; contacts.area.len()]),
            (false, _) => Ok(vec![[0.0; 3]; contacts.area.len()]),
        }
    }
}

/// The stones with another slope and friction, in steps of 50 us.
fn scene(space: &str, tilt: f64, friction: &str) -> String {
    let (sin, cos) = tilt.to_radians().sin_cos();
    text(space)
        .replace("\"20 deg\"", &format!("\"{tilt} deg\""))
        .replace("\"3.42 m/s2\"", &format!("\"{} m/s2\"", 10.0 * sin))
        .replace("\"-9.397 m/s2\"", &format!("\"{} m/s2\"", -10.0 * cos))
        .replace("\"35 deg\"", friction)
        .replace("[[phases]]", "[[phases]]\ntime_step = \"50 us\"")
}

fn residual(live: &Live) -> f64 {
    live.simulation().field::<&str>("energy.residual_relative", &[]).unwrap()
}

#[test]
fn a_damper_slows_a_stone_as_the_closed_form_and_its_work_is_a_line_of_the_ledger() {
    for space in ["planar", "spatial"] {
        let mut live = live(&scene(space, 0.0, "\"0 deg\""), None);
        on(&mut live, 0.1);
        live.change("remove = [\"high\"]").unwrap();
        on(&mut live, 0.2);
        live.set_velocity("low", Some([1.0, 0.0, 0.0]), None).unwrap();
        // The stone of 2500 kg on a square metre, or each metre of it.
        live.contact_law("damper", &["low"], Box::new(Damper(2.5e3))).unwrap();
        on(&mut live, 0.5);
        let v = speed(&live, "low");
        let closed = (-0.3_f64).exp();
        assert!((v - closed).abs() < 2e-3 * closed, "{space}: {v} {closed}");
        let work = live.simulation().field("load.work", &["law damper"]).unwrap();
        let lost = 0.5 * 2500.0 * (1.0 - closed * closed);
        assert!((work + lost).abs() < 3e-3 * lost, "{space}: {work} {lost}");
        assert!(residual(&live).abs() < 1e-6, "{space}: {:e}", residual(&live));
        // It pushes the fixed table as it holds the stone back: nothing is lost of the momentum between the two.
        let cost = &live.simulation().law_costs()[0];
        assert!(cost.calls >= 2000 && cost.seconds > 0.0, "{cost:?}");
    }
}

/// A stone on a slope of 20 degrees with 5 degrees of friction, glued on.
fn glued(space: &str, folder: Option<&Path>, strength: f64) -> Live {
    let mut live = live(&scene(space, 20.0, "\"5 deg\""), folder);
    live.contact_law("glue", &["low", "table"], Box::new(Glue { stiffness: 1e8, strength }))
        .unwrap();
    live
}

#[test]
fn glue_holds_a_stone_up_to_its_strength_and_forgets_nothing() {
    for space in ["planar", "spatial"] {
        let tilt = 20f64.to_radians();
        let drive = 10.0 * (tilt.sin() - tilt.cos() * 5f64.to_radians().tan());
        // Both stones slide together, 3750 kg on one square metre.
        let mut holds = glued(space, None, 20e3);
        on(&mut holds, 0.39);
        let moved = holds.simulation().field("block.displacement.x", &["low"]).unwrap();
        assert!(moved < 1e-3 && speed(&holds, "low") < 0.05, "{space}: {moved}");
        let mut slides = glued(space, None, 1e3);
        on(&mut slides, 0.39);
        let v = speed(&slides, "low");
        assert!((v - 0.39 * drive).abs() < 0.03 * 0.39 * drive, "{space}: {v} {}", 0.39 * drive);
        assert!(residual(&slides).abs() < 1e-5, "{space}: {:e}", residual(&slides));
    }
}

#[test]
fn a_run_with_a_law_goes_on_with_the_same_bits_where_the_law_is_given_again() {
    for space in ["planar", "spatial"] {
        let law = || Box::new(Glue { stiffness: 1e8, strength: 8e3 });
        let folder = tempfile::tempdir().unwrap();
        let path = folder.path().join(space);
        let mut whole = glued(space, None, 8e3);
        whole.advance(Pause::NEVER, &mut |_| Control::Continue).unwrap();
        let mut first = glued(space, Some(&path), 8e3);
        on(&mut first, 0.05);
        first.close().unwrap();
        let mut bare = Live::reopen(&path, 1).unwrap();
        let said = bare.advance(Pause::NEVER, &mut |_| Control::Continue).unwrap_err().to_string();
        assert!(said.contains("contact law `glue`") && said.contains("not known here"), "{said}");
        drop(bare);
        let mut again = Live::reopen(&path, 2).unwrap();
        let other = told(again.contact_law("glue", &["low"], law()));
        assert!(other.contains("the run has it on contacts of `low`, `table`"), "{other}");
        again.contact_law("glue", &["low", "table"], law()).unwrap();
        again.advance(Pause::NEVER, &mut |_| Control::Continue).unwrap();
        let hashes = [&whole, &again].map(|live| live.simulation().engine().hash());
        assert_eq!(hashes[0], hashes[1], "{space}");
        let events = std::fs::read_to_string(path.join("events.jsonl")).unwrap();
        assert_eq!(events.matches("\"contact law\"").count(), 2, "{events}");
    }
}

#[test]
fn a_law_that_fails_stops_the_run_with_a_checkpoint_and_names_the_contact() {
    for (number, words) in [
        (false, "no more"),
        (true, "its traction is not finite at the contact of `table` and `low`"),
    ] {
        let folder = tempfile::tempdir().unwrap();
        let path = folder.path().join("bad");
        let mut live = live(&scene("planar", 20.0, "\"35 deg\""), Some(&path));
        let bad = Bad { after: 0.05, number };
        live.contact_law("mine", &["low"], Box::new(bad)).unwrap();
        let said = live.advance(Pause::NEVER, &mut |_| Control::Continue).unwrap_err();
        assert!(matches!(said, JobError::Drive(DriveError::Law(_))), "{said}");
        let said = said.to_string();
        assert!(said.contains("contact law `mine` at step 100") && said.contains(words), "{said}");
        live.close().unwrap();
        assert_eq!(Manifest::read(&path).unwrap().ended, Ended::Interrupted);
        let mut again = Live::reopen(&path, 1).unwrap();
        again.contact_law("mine", &["low"], Box::new(Damper(0.0))).unwrap();
        again.advance(Pause::NEVER, &mut |_| Control::Continue).unwrap();
        assert!(again.ending().is_some());
    }
}

#[test]
fn what_takes_no_law_is_refused_by_name() {
    let damper = || Box::new(Damper(1.0));
    let mut flat = live(&scene("planar", 20.0, "\"35 deg\""), None);
    on(&mut flat, 0.01);
    let before = flat.simulation().engine().hash();
    for (of, why) in [
        (vec!["lo"], "contact_law: there is no block or group \"lo\"; did you mean \"low\"?"),
        (vec![], "give one group, or two"),
        (vec!["low", "high", "table"], "give one group, or two"),
    ] {
        let said = told(flat.contact_law("mine", &of, damper()));
        assert!(said.contains(why), "{said}");
    }
    assert_eq!(flat.simulation().engine().hash(), before);
    flat.contact_law("mine", &["low"], damper()).unwrap();
    let said = told(flat.contact_law("mine", &["low"], damper()));
    assert!(said.contains("there is a law of this name"), "{said}");
    let text =
        text("spatial").replace("name = \"lie\"", "name = \"lie\"\nintegration = \"implicit\"");
    let mut implicit = live(&text.replace("damping_ratio = 0.3", "restitution = 0.5"), None);
    on(&mut implicit, 0.01);
    let said = told(implicit.contact_law("mine", &["low"], damper()));
    assert!(said.contains("phase `lie` is implicit"), "{said}");
}
