//! Work of single conditions: what each boundary, support and load of a scene has in the lines of the ledger.
//!
//! A step books the work of one condition with the velocities and forces of the kick, as the ledger does for all of them
//! ([`crate::ledger`]), in the order of the scene and on one thread: the sums are the same bits for any number of threads, and those
//! over all conditions are the lines of the ledger but for round-off.
//!
//! What no condition of the scene does has no account: standing water, what removed blocks gave and fades, `fix` of a phase.

use serde::{Deserialize, Serialize};

/// What an account is of, with the place in the list of the setup.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
pub enum Holder {
    /// A condition on faces; in the plane a side of the model.
    Boundary(u16),
    /// A support of whole blocks.
    Support(u16),
    /// A support of nodes.
    Nodes(u16),
    /// Loads: those that name the account.
    Load,
}

impl Holder {
    /// The word of the scene for it, which stands before the dot of its fields.
    #[must_use]
    pub fn word(self) -> &'static str {
        match self {
            Self::Boundary(_) => "boundary",
            Self::Support(_) | Self::Nodes(_) => "support",
            Self::Load => "load",
        }
    }

    /// The number by which its fields are read: of a boundary that in the scene, of others that of the `account`.
    #[must_use]
    pub fn number(self, account: u32) -> u32 {
        match self {
            Self::Boundary(k) => u32::from(k),
            Self::Support(_) | Self::Nodes(_) | Self::Load => account,
        }
    }
}

/// A condition whose work is told.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize)]
pub struct Condition {
    /// Name in the scene, or what stands for one.
    pub name: String,
    /// What it is.
    pub holder: Holder,
}

/// Work of a condition since the start by the lines of the ledger, J (in the plane J/m).
#[derive(Clone, Copy, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct Account {
    /// Of its given forces.
    pub loads: f64,
    /// Of the motion that it prescribes.
    pub supports: f64,
    /// What its dashpots have taken.
    pub absorbed: f64,
}

impl Account {
    /// Work that it has done on the model.
    #[must_use]
    pub fn work(&self) -> f64 {
        self.loads + self.supports - self.absorbed
    }

    /// Adds another.
    pub fn add(&mut self, other: &Self) {
        self.loads += other.loads;
        self.supports += other.supports;
        self.absorbed += other.absorbed;
    }
}

/// A line of an account.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Line {
    /// Given forces.
    Loads,
    /// Prescribed motion.
    Supports,
    /// Dashpots.
    Absorbed,
}

/// Work of conditions in one step, before and after the present time.
#[derive(Clone, Debug, Default)]
pub struct Entries {
    /// In the half step before the present time.
    pub arrival: Vec<Account>,
    /// In the half step after it.
    pub departure: Vec<Account>,
}

impl Entries {
    /// Nothing on `count` accounts.
    pub fn clear(&mut self, count: usize) {
        for half in [&mut self.arrival, &mut self.departure] {
            half.clear();
            half.resize(count, Account::default());
        }
    }

    /// Adds the work of the half step after the present time to the accounts, once.
    pub fn depart(&mut self, accounts: &mut [Account]) {
        add(accounts, &self.departure);
        self.departure.clear();
    }

    /// Adds what was booked in the halves before and after to account number `of`.
    pub fn add(&mut self, of: u16, halves: &[Account; 2]) {
        self.arrival[usize::from(of)].add(&halves[0]);
        self.departure[usize::from(of)].add(&halves[1]);
    }

    /// Adds `work` of the halves before and after (J) to a line of account number `of`.
    pub fn book(&mut self, of: u16, line: Line, work: [f64; 2]) {
        let halves = [&mut self.arrival, &mut self.departure];
        for (half, work) in halves.into_iter().zip(work) {
            let account = &mut half[usize::from(of)];
            *match line {
                Line::Loads => &mut account.loads,
                Line::Supports => &mut account.supports,
                Line::Absorbed => &mut account.absorbed,
            } += work;
        }
    }
}

/// Adds the work of a half step to accounts.
pub fn add(accounts: &mut [Account], half: &[Account]) {
    for (account, half) in accounts.iter_mut().zip(half) {
        account.add(half);
    }
}

/// Number of the account of a holder, if it has one.
#[must_use]
pub fn of(conditions: &[Condition], holder: Holder) -> Option<u16> {
    let place = conditions.iter().position(|c| c.holder == holder)?;
    u16::try_from(place).ok()
}
