//! Colours: perceptual maps for fields, a palette for lines.

/// A map from 0..1 to colours, by equidistant samples.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum ColourMap {
    /// viridis (matplotlib, CC0): dark to bright, for amounts.
    Viridis,
    /// Cool to warm through grey (Moreland 2009): for signed values, grey at zero.
    CoolWarm,
}

#[rustfmt::skip]
const VIRIDIS: [[u8; 3]; 33] = [
    [68, 1, 84], [71, 13, 96], [72, 24, 106], [72, 35, 116], [71, 45, 123], [69, 55, 129], [66, 64, 134],
    [62, 73, 137], [59, 82, 139], [55, 91, 141], [51, 99, 141], [47, 107, 142], [44, 114, 142], [41, 122, 142],
    [38, 130, 142], [35, 137, 142], [33, 145, 140], [31, 152, 139], [31, 160, 136], [34, 167, 133],
    [40, 174, 128], [50, 182, 122], [63, 188, 115], [78, 195, 107], [94, 201, 98], [112, 207, 87],
    [132, 212, 75], [152, 216, 62], [173, 220, 48], [194, 223, 35], [216, 226, 25], [236, 229, 27],
    [253, 231, 37],
];

#[rustfmt::skip]
const COOL_WARM: [[u8; 3]; 33] = [
    [59, 76, 192], [68, 90, 204], [78, 104, 216], [88, 117, 225], [98, 130, 234], [108, 143, 241],
    [119, 154, 247], [130, 166, 251], [141, 176, 254], [152, 185, 255], [163, 194, 254], [174, 201, 252],
    [185, 208, 249], [195, 213, 244], [204, 217, 237], [213, 219, 229], [221, 220, 220], [229, 216, 209],
    [236, 211, 197], [241, 204, 184], [245, 196, 172], [247, 186, 159], [247, 176, 147], [246, 165, 134],
    [244, 152, 122], [240, 139, 110], [235, 125, 98], [228, 110, 86], [221, 95, 75], [212, 78, 65],
    [202, 59, 55], [190, 36, 46], [180, 4, 38],
];

/// Okabe and Ito's colours, told apart by colour-blind readers too; black first.
pub(super) const LINES: [&str; 8] = [
    "#000000", "#0072b2", "#d55e00", "#009e73", "#cc79a7", "#e69f00", "#56b4e9", "#8a7f00",
];

impl ColourMap {
    /// Colour at `share` (clamped to 0..1; not-a-number is white) as `#rrggbb`.
    pub fn at(self, share: f64) -> String {
        let samples = match self {
            ColourMap::Viridis => &VIRIDIS,
            ColourMap::CoolWarm => &COOL_WARM,
        };
        if share.is_nan() {
            return "#ffffff".to_owned();
        }
        let x = share.clamp(0.0, 1.0) * (samples.len() - 1) as f64;
        let i = (x as usize).min(samples.len() - 2);
        let f = x - i as f64;
        let mix = |k: usize| {
            let (a, b) = (f64::from(samples[i][k]), f64::from(samples[i + 1][k]));
            (a + f * (b - a)).round() as u8
        };
        format!("#{:02x}{:02x}{:02x}", mix(0), mix(1), mix(2))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn ends_and_middle() {
        assert_eq!(ColourMap::Viridis.at(0.0), "#440154");
        assert_eq!(ColourMap::Viridis.at(7.0), "#fde725");
        assert_eq!(ColourMap::CoolWarm.at(0.5), "#dddcdc");
        assert_eq!(ColourMap::CoolWarm.at(f64::NAN), "#ffffff");
    }
}
