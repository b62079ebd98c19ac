//! Answers as a table and in words.

use super::{Answer, Block, Kind, Plane, azimuth};
use crate::Vec3;

/// Columns of the table.
const HEADS: [&str; 24] = [
    "block",
    "round",
    "type",
    "mode",
    "factor_of_safety",
    "volume_m3",
    "weight_N",
    "free_area_m2",
    "driving_N",
    "resisting_N",
    "support_force_N",
    "support_pressure_Pa",
    "x_m",
    "y_m",
    "z_m",
    "direction_x",
    "direction_y",
    "direction_z",
    "trend_deg",
    "plunge_deg",
    "planes",
    "pressing_N",
    "areas_m2",
    "interfaces",
];

impl Kind {
    /// How it is told: `key block`.
    #[must_use]
    pub fn word(self) -> &'static str {
        match self {
            Self::Key => "key block",
            Self::Potential => "held by strength",
            Self::Safe => "held by weight",
            Self::Tapered => "tapered",
            Self::Inside => "inside",
            Self::Ground => "ground",
        }
    }

    /// The number of Goodman & Shi (1985); of blocks inside, which they do not number, none.
    #[must_use]
    pub fn number(self) -> &'static str {
        match self {
            Self::Key => "I",
            Self::Potential => "II",
            Self::Safe => "III",
            Self::Tapered => "IV",
            Self::Inside => "",
            Self::Ground => "V",
        }
    }
}

impl Plane {
    /// Dip and dip direction: `60/120`.
    #[must_use]
    pub fn attitude(&self) -> String {
        // What is rounded up to a whole turn is north.
        format!("{:02.0}/{:03.0}", self.dip, self.dip_direction.round() % 360.0)
    }
}

impl Block {
    /// Azimuth of its motion and angle below the horizon, deg.
    #[must_use]
    pub fn trend_and_plunge(&self) -> [f64; 2] {
        let [x, y, z] = self.direction;
        let level = (x * x + y * y).sqrt();
        [azimuth(Vec3::from(self.direction)), libm::atan2(-z, level).to_degrees()]
    }

    /// How it goes: `falls`, `slides on 35/090`, `slides on 50/050 and 50/130`; with ` along` for planes that do not press.
    #[must_use]
    pub fn way(&self) -> String {
        let told = |plane: &Plane| match plane.interfaces[..] {
            [] => format!("{} (roller)", plane.attitude()),
            [_, ..] => plane.attitude(),
        };
        let planes: Vec<String> = self.planes.iter().map(told).collect();
        match self.mode {
            "held" => "stays".to_owned(),
            "falling" if planes.is_empty() => "falls".to_owned(),
            "falling" => format!("falls along {}", planes.join(", ")),
            mode => {
                let count = if mode == "wedge" { 2 } else { 1 };
                let (pressed, along) = planes.split_at(count.min(planes.len()));
                let along = match along {
                    [] => String::new(),
                    some => format!(", along {}", some.join(", ")),
                };
                format!("slides on {}{along}", pressed.join(" and "))
            }
        }
    }

    fn row(&self) -> Vec<String> {
        let [x, y, z] = self.centroid;
        let [along_x, along_y, along_z] = self.direction;
        let [trend, plunge] = self.trend_and_plunge();
        let each = |of: &dyn Fn(&Plane) -> String| {
            self.planes.iter().map(of).collect::<Vec<_>>().join(" ")
        };
        let number = |value: f64| value.to_string();
        let mut row = vec![
            self.name.clone(),
            self.round.to_string(),
            self.kind.number().to_owned(),
            self.mode.to_owned(),
        ];
        row.extend(
            [
                self.factor_of_safety,
                self.volume,
                self.weight,
                self.free_area,
                self.driving,
                self.resisting,
                self.support_force,
            ]
            .map(number),
        );
        row.push(self.support_pressure.map_or_else(String::new, number));
        row.extend([x, y, z, along_x, along_y, along_z, trend, plunge].map(number));
        row.push(each(&Plane::attitude));
        row.push(each(&|plane| number(plane.pressing)));
        row.push(each(&|plane| number(plane.area)));
        row.push(each(&|plane| plane.interfaces.join("+")));
        row
    }
}

impl Answer {
    /// The blocks as CSV, SI; lists in a column are separated by spaces.
    ///
    /// # Errors
    /// Never in practice: it is written to memory.
    pub fn table(&self) -> Result<Vec<u8>, csv::Error> {
        let mut out = csv::Writer::from_writer(Vec::new());
        out.write_record(HEADS)?;
        for block in &self.blocks {
            out.write_record(block.row())?;
        }
        out.into_inner().map_err(|error| error.into_error().into())
    }

    /// Removable blocks; tapered ones are not.
    pub fn removable(&self) -> impl Iterator<Item = &Block> {
        self.blocks.iter().filter(|block| block.kind <= Kind::Safe)
    }

    /// How many blocks of each type: `3 removable blocks: 1 key block, 2 held by strength; ...`.
    #[must_use]
    pub fn words(&self) -> String {
        let count = |kind| self.blocks.iter().filter(|block| block.kind == kind).count();
        let all = self.removable().count();
        let keys = count(Kind::Key);
        let s = |n: usize| if n == 1 { "" } else { "s" };
        let mut text = format!(
            "{all} removable block{}: {keys} key block{}, {} held by strength, {} held by weight; not removable: {} tapered, {} inside, {} ground",
            s(all),
            s(keys),
            count(Kind::Potential),
            count(Kind::Safe),
            count(Kind::Tapered),
            self.inside,
            self.ground,
        );
        if self.rollers > 0 {
            text.push_str(&format!(
                "\n{} of the blocks that are no ground end{} at rollers, as at planes of symmetry, or {} held in some directions",
                self.rollers,
                if self.rollers == 1 { "s" } else { "" },
                if self.rollers == 1 { "is" } else { "are" }
            ));
        }
        if !self.not_counted.is_empty() {
            text.push_str(&format!("\nnot counted: {}", self.not_counted.join(", ")));
        }
        text
    }
}
