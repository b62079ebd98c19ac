//! Laws of code at contacts: what a user's function adds to the response of contacts and joints.
//!
//! A law is asked once a step, when contacts and joints of the instant are known and before the kick, for all contacts of one group at a time. What it
//! answers is a traction on the first block of each; the second gets the opposite at the same point. It acts *beside* the built-in response, whose
//! parameters stay those of the interface. Its forces are a load of its own, `law NAME`, so that the ledger has their work on a line of its own.
//!
//! Relative displacements are summed by half-step velocities, as the leapfrog moves blocks: a spring by a law keeps its energy as one that is built in.
//! They and the memory of a law are part of a checkpoint; the function is not, and a run that has a law goes on only where that is given again.

use std::time::{Duration, Instant};

use super::law_state::{Acting, Held};
use super::{ChangeError, RunError, Simulation};
use crate::plan::Damping;
use crate::run::engine::{Met, View, Wrenches, wrench};

/// A law that code puts on contacts of a group.
pub trait ContactLaw: std::fmt::Debug + Send {
    /// Numbers that it remembers of each contact.
    fn memory(&self) -> usize {
        0
    }

    /// Traction (Pa) on the first block of each contact, in their order, and in [`Contacts::memory`] what it remembers from now on. Called once a step
    /// for the same instant; again where a run goes back to that instant, for a change or after a restart.
    ///
    /// # Errors
    /// What stops the run, with a checkpoint, in words.
    fn tractions(&mut self, contacts: &mut Contacts) -> Result<Vec<[f64; 3]>, String>;
}

/// Contacts and joints of a group, in a fixed order. In the plane the third components are 0.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Contacts {
    /// Model time, s.
    pub time: f64,
    /// Numbers of the blocks.
    pub blocks: Vec<[u32; 2]>,
    /// Whether a joint of the start joins them; a found contact otherwise.
    pub joint: Vec<bool>,
    /// Point, m.
    pub point: Vec<[f64; 3]>,
    /// Unit normal from the first block to the second; zero of a touch without one.
    pub normal: Vec<[f64; 3]>,
    /// Area, m²; in the plane length, m (tractions are then N/m over this length).
    pub area: Vec<f64>,
    /// Displacement of the second block against the first at the point since the law has first seen the contact, m; along the normal it opens. It turns with
    /// the normal.
    pub displacement: Vec<[f64; 3]>,
    /// Velocity of the second block against the first at the point, m/s, in the last half step.
    pub velocity: Vec<[f64; 3]>,
    /// Force of the built-in response on the first block, N; in the plane N/m.
    pub force: Vec<[f64; 3]>,
    /// What the law remembers, as many numbers for each contact as it asks for; zeros of a new one. *Shape* `[contacts * memory]`.
    pub memory: Vec<f64>,
}

/// A law with what it has cost.
#[derive(Debug)]
pub(super) struct Attached {
    name: String,
    law: Box<dyn ContactLaw>,
    calls: u64,
    spent: Duration,
    /// Blocks of its groups, known for a number of blocks of the model.
    sides: Option<(usize, Vec<Vec<bool>>)>,
}

/// What a law has cost.
#[derive(Clone, Debug, PartialEq)]
pub struct LawCost {
    /// Its name.
    pub name: String,
    /// How often it was asked.
    pub calls: u64,
    /// Wall time in it, s.
    pub seconds: f64,
}

/// Turns a vector as the shortest way from one unit vector to another turns that (Rodrigues' formula).
fn turned(v: [f64; 3], from: [f64; 3], to: [f64; 3]) -> [f64; 3] {
    let dot = |a: [f64; 3], b: [f64; 3]| a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
    let cross = |a: [f64; 3], b: [f64; 3]| wrench(b, a)[1];
    let cos = dot(from, to);
    if from == to || from == [0.0; 3] || to == [0.0; 3] || cos <= -0.5 {
        return v;
    }
    let axis = cross(from, to);
    let (around, along) = (cross(axis, v), dot(axis, v) / (1.0 + cos));
    [0, 1, 2].map(|k| cos * v[k] + around[k] + along * axis[k])
}

impl Held {
    /// Contacts of the instant that are the law's, with what was remembered of them; `asked`: blocks of its sides. `dt`: of the last step, s.
    fn update(&mut self, met: &[Met], sides: &[Vec<bool>], dt: f64) -> Vec<Met> {
        let is = |side: usize, b: u32| sides[side].get(b as usize).copied().unwrap_or(false);
        let chosen = |one: &&Met| match (sides.len(), one.ends) {
            (1, [a, b]) => is(0, a) || is(0, b),
            (_, [a, b]) => is(0, a) && is(1, b) || is(0, b) && is(1, a),
        };
        let mine: Vec<Met> = met.iter().filter(chosen).copied().collect();
        let mut before = std::mem::take(&mut self.contacts);
        before.sort_by_key(|one| (one.ends, one.joint, one.nth));
        let mut seen = std::collections::BTreeMap::new();
        for one in &mine {
            let count: &mut u32 = seen.entry((one.ends, one.joint)).or_default();
            let (nth, key) = (*count, (one.ends, one.joint, *count));
            *count += 1;
            let new = Acting {
                ends: one.ends,
                joint: one.joint,
                nth,
                normal: one.normal,
                arms: one.arms,
                memory: vec![0.0; self.width],
                ..Acting::default()
            };
            let old = before.binary_search_by_key(&key, |old| (old.ends, old.joint, old.nth));
            self.contacts.push(match old.map(|k| std::mem::take(&mut before[k])) {
                Err(_) => new,
                Ok(old) => {
                    let moved = turned(old.displacement, old.normal, one.normal);
                    let displacement = [0, 1, 2].map(|k| moved[k] + dt * one.velocity[k]);
                    Acting { displacement, memory: old.memory, ..new }
                }
            });
        }
        mine
    }

    /// What the law is shown.
    fn shown(&self, mine: &[Met], time: f64) -> Contacts {
        Contacts {
            time,
            blocks: mine.iter().map(|one| one.ends).collect(),
            joint: mine.iter().map(|one| one.joint).collect(),
            point: mine.iter().map(|one| one.point).collect(),
            normal: mine.iter().map(|one| one.normal).collect(),
            area: mine.iter().map(|one| one.area).collect(),
            displacement: self.contacts.iter().map(|one| one.displacement).collect(),
            velocity: mine.iter().map(|one| one.velocity).collect(),
            force: mine.iter().map(|one| one.force).collect(),
            memory: self.contacts.iter().flat_map(|one| one.memory.iter().copied()).collect(),
        }
    }

    /// Takes what the law answered; what is wrong with it, in words.
    fn answered(
        &mut self,
        mine: &[Met],
        tractions: &[[f64; 3]],
        memory: &[f64],
        name_of: impl Fn(u32) -> String,
    ) -> Result<(), String> {
        let (count, width) = (mine.len(), self.width);
        if tractions.len() != count {
            return Err(format!("it gave {} tractions for {count} contacts", tractions.len()));
        }
        if memory.len() != count * width {
            return Err(format!("its memory has {} numbers, not {}", memory.len(), count * width));
        }
        for (k, (acting, one)) in self.contacts.iter_mut().zip(mine).enumerate() {
            let kept = &memory[k * width..(k + 1) * width];
            let bad = match (
                tractions[k].iter().all(|t| t.is_finite()),
                kept.iter().all(|m| m.is_finite()),
            ) {
                (true, true) => None,
                (false, _) => Some("traction"),
                (true, false) => Some("memory"),
            };
            if let Some(what) = bad {
                let [a, b] = one.ends.map(&name_of);
                let [x, y, z] = one.point;
                return Err(format!(
                    "its {what} is not finite at the contact of `{a}` and `{b}` at ({x:.4}, {y:.4}, {z:.4}) m"
                ));
            }
            acting.force = tractions[k].map(|t| t * one.area);
            acting.memory.clear();
            acting.memory.extend_from_slice(kept);
        }
        Ok(())
    }

    /// Forces and moments on `count` blocks. What has been removed since neither acts nor is acted on.
    fn wrenches(&self, count: usize, there: impl Fn(u32) -> bool) -> Wrenches {
        let mut all: Wrenches = vec![[[0.0; 3]; 2]; count];
        for one in self.contacts.iter().filter(|one| one.ends.into_iter().all(&there)) {
            for (side, sign) in [(0, 1.0), (1, -1.0)] {
                let push = wrench(one.force.map(|f| sign * f), one.arms[side]);
                let to = &mut all[one.ends[side] as usize];
                for (to, push) in to.as_flattened_mut().iter_mut().zip(push.as_flattened()) {
                    *to += push;
                }
            }
        }
        all
    }
}

impl Attached {
    /// Asks the law at a new instant; what is wrong, in words.
    fn ask(&mut self, held: &mut Held, view: &View<'_>, met: &[Met]) -> Result<(), String> {
        let Some((_, sides)) = &self.sides else { return Ok(()) };
        let mine = held.update(met, sides, view.last_dt());
        let mut shown = held.shown(&mine, view.time());
        let begun = Instant::now();
        let tractions = self.law.tractions(&mut shown);
        self.spent += begun.elapsed();
        self.calls += 1;
        held.answered(&mine, &tractions?, &shown.memory, |b| view.name(b))?;
        held.step = Some(view.step());
        Ok(())
    }
}

impl Simulation {
    /// Puts a law of code on contacts and joints of rigid blocks: all of one group or block (`of` has one name), or those between two. Its work is
    /// that of the load `law NAME`. A run that goes on from a checkpoint is given the law again, by the same name for the same groups.
    ///
    /// The automatic time step does not know its stiffness and its dampers: give `time_step` where they are large.
    ///
    /// # Errors
    /// Names of nothing, blocks that deform, a name that another law has, phases that are implicit, relax or step by levels, several ranks.
    pub fn contact_law(
        &mut self,
        name: &str,
        of: &[&str],
        law: Box<dyn ContactLaw>,
    ) -> Result<(), ChangeError> {
        let width = law.memory();
        self.attach_law(name, law)?;
        let begun = self.begin_law(name, of, width);
        if begun.is_err() {
            self.detach_law(name);
        }
        begun
    }

    /// What laws of code have cost so far in this process.
    #[must_use]
    pub fn law_costs(&self) -> Vec<LawCost> {
        let cost = |one: &Attached| LawCost {
            name: one.name.clone(),
            calls: one.calls,
            seconds: one.spent.as_secs_f64(),
        };
        self.laws.iter().map(cost).collect()
    }

    /// Whether laws of code act.
    #[must_use]
    pub(crate) fn has_laws(&self) -> bool {
        !self.cursor.laws.is_empty()
    }

    /// The function of a law.
    pub(crate) fn attach_law(
        &mut self,
        name: &str,
        law: Box<dyn ContactLaw>,
    ) -> Result<(), ChangeError> {
        if self.laws.iter().any(|one| one.name == name) {
            let why = "there is a law of this name".to_owned();
            return Err(ChangeError::Law { name: name.to_owned(), why });
        }
        let name = name.to_owned();
        self.laws.push(Attached { name, law, calls: 0, spent: Duration::ZERO, sides: None });
        Ok(())
    }

    /// Takes the function of a law away.
    pub(crate) fn detach_law(&mut self, name: &str) {
        self.laws.retain(|one| one.name != name);
    }

    /// What a checkpoint holds of a law, from now on.
    pub(crate) fn begin_law(
        &mut self,
        name: &str,
        of: &[&str],
        width: usize,
    ) -> Result<(), ChangeError> {
        let wrong = |why: String| ChangeError::Law { name: name.to_owned(), why };
        if name.trim().is_empty() {
            return Err(wrong("its name is empty".to_owned()));
        }
        if !matches!(of.len(), 1 | 2) {
            return Err(wrong("give one group, or two between which it acts".to_owned()));
        }
        if self.phase().is_none() {
            return Err(ChangeError::Ended);
        }
        if let Some(held) = self.cursor.laws.iter().find(|held| held.name == name) {
            if held.of != of || held.width != width {
                let were = held.of.join("`, `");
                return Err(wrong(format!(
                    "the run has it on contacts of `{were}` with {} numbers of memory",
                    held.width
                )));
            }
            self.stand_anew(name);
            return Ok(());
        }
        for key in of {
            for b in self.blocks_of("contact_law", key)? {
                if self.engine.nodes(b).is_some() {
                    let block = self.view().name(b);
                    return Err(wrong(format!(
                        "`{block}` deforms; it acts on contacts of rigid blocks"
                    )));
                }
            }
        }
        if let Some(why) = self.no_laws() {
            return Err(wrong(why));
        }
        let of = of.iter().map(|name| (*name).to_owned()).collect();
        self.cursor.laws.push(Held { name: name.to_owned(), of, width, ..Held::default() });
        self.engine.make_room(&account(name));
        self.stand_anew(name);
        Ok(())
    }

    /// Forces are those without the law until they are found again.
    fn stand_anew(&mut self, name: &str) {
        self.standing = false;
        for law in self.laws.iter_mut().filter(|law| law.name == name) {
            law.sides = None;
        }
    }

    /// Why the present phase takes no laws of code, in words.
    fn no_laws(&self) -> Option<String> {
        let phase = self.phase();
        let what = if self.engine.exec().peers().is_some() {
            return Some("the model is shared out among ranks; run it on one".to_owned());
        } else if self.engine.is_implicit() {
            "is implicit"
        } else if self.relaxes() {
            "relaxes deformable blocks"
        } else if phase.is_some_and(|phase| phase.levels > 0) {
            "steps by levels"
        } else {
            return None;
        };
        let name = phase.map_or("", |phase| phase.name.as_str());
        Some(format!("phase `{name}` {what}; laws of code act in explicit phases without levels"))
    }

    /// Finds the forces of the present instant.
    pub(super) fn evaluate(&mut self, damping: &Damping, dt: f64) -> Result<(), RunError> {
        if self.has_laws() {
            return self.evaluate_with_laws(damping, dt);
        }
        self.engine.evaluate(damping, dt).map_err(|block| self.no_force(block))
    }

    /// The same with what laws of code add.
    fn evaluate_with_laws(&mut self, damping: &Damping, dt: f64) -> Result<(), RunError> {
        let (step, time) = (self.steps(), self.time());
        let wrong = |law: &str, why: String| RunError::Law { law: law.to_owned(), why, step, time };
        for held in &self.cursor.laws {
            if !self.laws.iter().any(|one| one.name == held.name) {
                let why = "its function is not known here; give it again with `contact_law` before the run goes on";
                return Err(wrong(&held.name, why.to_owned()));
            }
        }
        if let (Some(why), Some(held)) = (self.no_laws(), self.cursor.laws.first()) {
            return Err(wrong(&held.name, why));
        }
        self.know_sides();
        let count = self.view().all_blocks();
        let names: Vec<String> = self.cursor.laws.iter().map(|held| account(&held.name)).collect();
        let accounts: Vec<u16> = names.iter().map(|name| self.engine.make_room(name)).collect();
        let Self { engine, cursor, laws, .. } = self;
        let mut failed = None;
        let found = engine.evaluate_with(damping, dt, &accounts, &mut |view| {
            let mut met = None;
            let mut find = |held: &mut Held| {
                let law = laws.iter_mut().find(|one| one.name == held.name);
                // Asked once an instant: what it said then holds for what is evaluated again.
                if held.step != Some(step)
                    && failed.is_none()
                    && let Some(law) = law
                {
                    let met = met.get_or_insert_with(|| view.met());
                    failed = law.ask(held, &view, met).err().map(|why| (held.name.clone(), why));
                }
                held.wrenches(count, |b| view.is_alive(b))
            };
            cursor.laws.iter_mut().map(&mut find).collect()
        });
        if let Some((law, why)) = failed {
            return Err(wrong(&law, why));
        }
        found.map_err(|block| self.no_force(block))
    }

    /// Asks laws of code at the present instant, before a motion is ended there.
    pub(super) fn meet_laws(&mut self, damping: &Damping) -> Result<(), RunError> {
        if self.cursor.laws.is_empty() { Ok(()) } else { self.evaluate(damping, 0.0) }
    }

    /// Looks up the blocks of the groups of laws where blocks have been added since.
    fn know_sides(&mut self) {
        let count = self.view().all_blocks();
        for k in 0..self.laws.len() {
            if self.laws[k].sides.as_ref().is_some_and(|(known, _)| *known == count) {
                continue;
            }
            let held = self.cursor.laws.iter().find(|held| held.name == self.laws[k].name);
            let sides = held.iter().flat_map(|held| &held.of).map(|name| {
                let mut side = vec![false; count];
                for b in self.blocks_of("contact_law", name).into_iter().flatten() {
                    side[b as usize] = true;
                }
                side
            });
            let sides = sides.collect();
            self.laws[k].sides = Some((count, sides));
        }
    }
}

/// Name of the account of a law.
fn account(name: &str) -> String {
    format!("law {name}")
}
