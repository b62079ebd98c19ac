//! Answers in words and files.

use std::fmt::Write;
use std::path::Path;

use super::{Answer, Fragments, KuzRam, Part, Partition, Pile, Station, Throw};
use crate::numbers::counted;
use crate::plot::{Labels, Line, Share};
use crate::record::{OutputError, write_whole};

/// Profile of the pile, in the folder of the answer.
const PROFILE: &str = "profile.csv";
/// Sizes of fragments.
const SIEVE: &str = "sieve.csv";
/// Where the energy went.
const ENERGY: &str = "energy_partition.csv";
/// All numbers.
const SUMMARY: &str = "muckpile.json";

impl Answer {
    /// Writes tables and all numbers into a folder.
    ///
    /// # Errors
    /// The disk.
    pub fn write(&self, folder: &Path) -> Result<(), OutputError> {
        let pile = self.pile.as_ref().map(profile);
        let sieve = self.fragments.as_ref().map(|of| sieve(of, self.kuz_ram.as_ref()));
        let energy = self.energy.as_ref().map(energy);
        for (name, text) in [(PROFILE, pile), (SIEVE, sieve), (ENERGY, energy)] {
            if let Some(text) = text {
                write_whole(&folder.join(name), text.as_bytes())?;
            }
        }
        let text = serde_json::to_string_pretty(self).unwrap_or_default();
        write_whole(&folder.join(SUMMARY), text.as_bytes())
    }

    /// The profile of the pile over that of its ground, to be drawn.
    #[must_use]
    pub fn profile(&self) -> Option<(Line, Line, Labels)> {
        let stations = &self.pile.as_ref()?.profile;
        let line = |name: &str, height: fn(&Station) -> f64| Line {
            name: name.to_owned(),
            x: stations.iter().map(|s| s.at).collect(),
            y: stations.iter().map(height).collect(),
        };
        let labels = Labels {
            title: format!("muckpile of {}", self.run),
            x: ("along the throw".to_owned(), "m".to_owned()),
            y: ("height".to_owned(), "m".to_owned()),
        };
        let surface = line("surface of the pile", |s| s.surface);
        (!stations.is_empty()).then(|| (surface, line("ground", |s| s.ground), labels))
    }

    /// Where the energy came from and went, to be drawn: a title and the parts.
    #[must_use]
    pub fn shares(&self) -> Option<(String, Vec<Share>)> {
        let partition = self.energy.as_ref()?;
        let drawn = |source: bool| {
            move |part: &Part| Share {
                name: part.name.to_owned(),
                source,
                energy: part.energy,
                share: part.share,
                depends_on: part.depends_on.to_owned(),
            }
        };
        let from = partition.from.iter().map(drawn(true));
        let parts = from.chain(partition.to.iter().map(drawn(false))).collect();
        let mega = 1e-6 * partition.put_in;
        (partition.put_in > 0.0)
            .then(|| (format!("energy of {}: {mega:.4} MJ put in", self.run), parts))
    }

    /// The answer in words.
    #[must_use]
    pub fn words(&self) -> String {
        let mut lines = vec![format!("{} at {:.4} s", self.run, self.time)];
        match &self.throw {
            Some(throw) => lines.extend(thrown(throw)),
            None => lines.push("nothing was thrown".to_owned()),
        }
        if let Some(pile) = &self.pile {
            lines.push(format!(
                "muckpile: {:.1} m3 over {:.1} m2, {:.2} m high; swell {:.3}",
                pile.volume, pile.area, pile.height, pile.swell
            ));
        }
        if let Some(crater) = &self.crater {
            lines.push(format!(
                "crater: radius {:.3} m (of the circle of its {:.2} m2), depth {:.3} m, {:.2} m3",
                crater.radius, crater.area, crater.depth, crater.volume
            ));
        }
        if let Some(behind) = &self.behind {
            let loose =
                behind.loose.map_or(String::new(), |loose| format!(", loose up to {loose:.2} m"));
            lines.push(format!(
                "behind the last row: thrown up to {:.2} m (back-break){loose}, failed points up to {:.2} m",
                behind.back_break, behind.damaged
            ));
        }
        lines.extend(self.fragments.as_ref().map(sizes));
        lines.extend(self.kuz_ram.as_ref().map(kuz_ram));
        if let Some(gas) = &self.gas {
            lines.push(format!(
                "gas: {:.3} kg, {:.1} % vented, {:.1} % in cracks; of {:.3} MJ released {:.1} % done on rock ({:.1} % in cracks), {:.1} % left in it, {:.1} % carried \
                 off, {:.1} % lost in the flow",
                gas.mass,
                share(gas.vented, gas.mass),
                share(gas.in_cracks, gas.mass),
                1e-6 * gas.released,
                share(gas.work, gas.released),
                share(gas.work_in_cracks, gas.released),
                share(gas.internal, gas.released),
                share(gas.carried_off, gas.released),
                share(gas.friction, gas.released),
            ));
        }
        if let Some(partition) = &self.energy {
            lines.push(format!("energy, {:.4} MJ put in:", 1e-6 * partition.put_in));
            let put_in = partition.put_in;
            lines.extend(partition.from.iter().map(|part| told("from", part, put_in)));
            lines.extend(partition.to.iter().map(|part| told("to", part, put_in)));
        }
        lines.join("\n")
    }
}

fn share(part: f64, all: f64) -> f64 {
    if all > 0.0 { 100.0 * part / all } else { 0.0 }
}

fn thrown(throw: &Throw) -> Vec<String> {
    let mass = throw.mass.map_or(String::new(), |mass| format!(", {:.3} t", 1e-3 * mass));
    let [x, y, z] = throw.shift;
    let mut lines = vec![
        format!(
            "thrown: {}, {:.2} m3{mass}; their centroid moved by ({x:.2}, {y:.2}, {z:.2}) m; median throw {:.2} m, 90th percentile {:.2} m",
            counted(throw.blocks, "block"),
            throw.volume,
            throw.half,
            throw.most
        ),
        format!(
            "flyrock: {}; the largest beyond the 90th percentile is {}",
            flyer(&throw.farthest),
            flyer(&throw.largest_far)
        ),
    ];
    if throw.moving > 0 {
        lines.push(format!("not at rest: {} still moving", counted(throw.moving, "block")));
    }
    if throw.left.0 > 0 {
        let (blocks, mass) = throw.left;
        lines.push(format!(
            "left the model: {}, {:.3} t, in none of these numbers",
            counted(blocks, "block"),
            1e-3 * mass
        ));
    }
    lines
}

fn flyer(of: &super::Flyer) -> String {
    let charge = of.from_charge.map_or(String::new(), |d| format!(", {d:.2} m from a charge"));
    let mass = of.mass.map_or(String::new(), |mass| format!(", {mass:.1} kg"));
    format!("`{}`, {:.2} m{charge}, {:.2} m large{mass}", of.block, of.way, of.size)
}

fn sizes(of: &Fragments) -> String {
    let n = of.n.map_or("too few sizes for n".to_owned(), |n| format!("n = {n:.2}"));
    format!(
        "fragments: {}; x50 = {:.3} m, x80 = {:.3} m, {n}, largest {:.3} m",
        of.count, of.x50, of.x80, of.largest
    )
}

fn kuz_ram(of: &KuzRam) -> String {
    let x80 = of.x80.map_or(String::new(), |x80| format!(", x80 = {x80:.3} m"));
    format!(
        "Kuz-Ram: x50 = {:.3} m{x80} (A = {}, {:.3} kg/m3, {:.2} kg a hole, strength {} %)",
        of.x50, of.rock_factor, of.powder_factor, of.charge, of.strength
    )
}

fn told(way: &str, part: &Part, put_in: f64) -> String {
    // Of nothing there are no shares.
    let share = match put_in > 0.0 {
        true => format!("{:>7.2} %", 100.0 * part.share),
        false => " ".repeat(9),
    };
    let energy = 1e-6 * part.energy;
    format!("  {way:>4} {:<32} {energy:>12.4} MJ {share}  ({})", part.name, part.depends_on)
}

fn profile(pile: &Pile) -> String {
    let mut text = "at_m,surface_m,highest_m,ground_m,width_m\n".to_owned();
    for s in &pile.profile {
        let _ = writeln!(text, "{},{},{},{},{}", s.at, s.surface, s.highest, s.ground, s.width);
    }
    text
}

fn sieve(of: &Fragments, kuz_ram: Option<&KuzRam>) -> String {
    let curve = kuz_ram.and_then(|k| Some((k.x50, k.n?)));
    let mut text = "size_m,passing".to_owned();
    text.push_str(if curve.is_some() { ",kuz_ram\n" } else { "\n" });
    for [size, passing] in &of.curve {
        let _ = write!(text, "{size},{passing}");
        if let Some((x50, n)) = curve {
            let _ = write!(text, ",{}", 1.0 - libm::exp2(-libm::pow(size / x50, n)));
        }
        text.push('\n');
    }
    text
}

fn energy(partition: &Partition) -> String {
    let mut text = "way,name,energy_J,share,depends_on\n".to_owned();
    for (way, parts) in [("from", &partition.from), ("to", &partition.to)] {
        for part in parts {
            let _ = writeln!(
                text,
                "{way},\"{}\",{},{},\"{}\"",
                part.name, part.energy, part.share, part.depends_on
            );
        }
    }
    text
}
