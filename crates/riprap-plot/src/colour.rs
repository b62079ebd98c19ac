//! Colours: perceptual maps for fields, a palette for lines.

/// A map from 0..1 to colours, by equidistant samples.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum ColourMap {
    /// Yellow to blue (ColorBrewer YlGnBu without its palest part): for amounts. Most blocks of most runs have low values, whose light
    /// colours leave edges to be seen. The viewer's default.
    Light,
    /// Blue to red through white (ColorBrewer RdBu): for signed values, white at zero. The viewer's default for these.
    BlueRed,
}

#[rustfmt::skip]
const LIGHT: [[u8; 3]; 33] = [
    [235, 247, 185], [228, 245, 181], [221, 242, 180], [212, 238, 179], [202, 234, 180], [190, 230, 181],
    [177, 224, 182], [163, 219, 184], [148, 213, 185], [133, 207, 187], [118, 202, 189], [104, 196, 190],
    [91, 191, 192], [79, 185, 193], [67, 178, 194], [58, 171, 194], [49, 164, 193], [42, 155, 192],
    [37, 146, 190], [34, 136, 187], [33, 126, 183], [32, 116, 178], [33, 105, 173], [34, 95, 168],
    [34, 85, 163], [35, 75, 158], [34, 66, 152], [33, 59, 145], [30, 51, 136], [26, 45, 126], [20, 39, 114],
    [14, 34, 101], [8, 29, 88],
];

#[rustfmt::skip]
const BLUE_RED: [[u8; 3]; 33] = [
    [5, 48, 97], [14, 65, 120], [23, 81, 142], [32, 97, 160], [42, 113, 174], [54, 127, 184],
    [68, 142, 193], [86, 157, 200], [107, 172, 208], [130, 186, 216], [152, 199, 223], [173, 210, 229],
    [191, 220, 235], [208, 228, 239], [222, 235, 242], [233, 239, 242], [242, 239, 238], [247, 236, 229],
    [250, 228, 216], [251, 217, 199], [250, 204, 180], [247, 188, 160], [243, 170, 140], [236, 151, 122],
    [228, 130, 104], [219, 109, 89], [209, 87, 75], [198, 65, 63], [184, 45, 53], [168, 29, 45],
    [148, 17, 39], [126, 8, 35], [103, 0, 31],
];

/// Colours of kinds (Tableau 10), as in the viewer.
const KINDS: [&str; 10] = [
    "#4e79a7", "#f28e2c", "#e15759", "#76b7b2", "#59a14f", "#edc949", "#af7aa1", "#ff9da7",
    "#9c755f", "#bab0ab",
];

/// Hues of materials, as in the viewer.
pub(super) const MATERIALS: [&str; 10] = [
    "#c3ac87", "#86a3bd", "#b98474", "#93ab7d", "#a091b5", "#cda552", "#76aca4", "#bd93a8",
    "#a3a39a", "#d2bfa6",
];

/// Colour of a material by its number.
pub(super) fn material(number: f64) -> &'static str {
    if number >= 0.0 { MATERIALS[number.round() as usize % MATERIALS.len()] } else { "#ffffff" }
}

/// Colour of a kind by its number.
pub(super) fn kind(number: f64) -> &'static str {
    if number >= 0.0 { KINDS[number.round() as usize % KINDS.len()] } else { "#ffffff" }
}

/// Red, green and blue of the map *turbo* at `share` (clamped to 0..1), by the polynomial of A. Mikhailov (2019).
pub(super) fn turbo(share: f64) -> [f64; 3] {
    let t = share.clamp(0.0, 1.0);
    let of = |c: [f64; 6]| c.iter().rev().fold(0.0, |sum, c| sum * t + c);
    [
        of([34.61, 1172.33, -10793.56, 33300.12, -38394.49, 14825.05]),
        of([23.31, 557.33, 1225.33, -3574.96, 1073.77, 707.56]),
        of([27.2, 3211.1, -15327.97, 27814.0, -22569.18, 6838.66]),
    ]
    .map(|part| part.clamp(0.0, 255.0).round())
}

/// Whether a colour `#rrggbb` is so dark that black lines are lost on it.
pub(super) fn is_dark(colour: &str) -> bool {
    let part = |k: usize| u8::from_str_radix(colour.get(k..k + 2).unwrap_or("ff"), 16);
    let [r, g, b] = [1, 3, 5].map(|k| f64::from(part(k).unwrap_or(255)));
    0.299 * r + 0.587 * g + 0.114 * b < 105.0
}

/// Okabe and Ito's colours, told apart by colour-blind readers too; black first.
pub(super) const LINES: [&str; 8] =
    ["#000000", "#0072b2", "#d55e00", "#009e73", "#cc79a7", "#e69f00", "#56b4e9", "#8a7f00"];

impl ColourMap {
    /// Colour at `share` (clamped to 0..1; not-a-number is white) as `#rrggbb`.
    pub fn at(self, share: f64) -> String {
        let samples = match self {
            ColourMap::Light => &LIGHT,
            ColourMap::BlueRed => &BLUE_RED,
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
        assert_eq!(ColourMap::Light.at(0.0), "#ebf7b9");
        assert_eq!(ColourMap::Light.at(7.0), "#081d58");
        assert_eq!(ColourMap::BlueRed.at(0.5), "#f2efee");
        assert_eq!(ColourMap::BlueRed.at(f64::NAN), "#ffffff");
        assert_eq!([turbo(0.0), turbo(0.5)], [[35.0, 23.0, 27.0], [149.0, 251.0, 81.0]]);
        assert_eq!([kind(0.0), kind(12.0), kind(-1.0)], ["#4e79a7", "#e15759", "#ffffff"]);
    }

    #[test]
    fn lines_can_be_told_from_what_they_lie_on() {
        let dark: Vec<bool> =
            (0..=10).map(|k| is_dark(&ColourMap::Light.at(0.1 * f64::from(k)))).collect();
        assert!(!dark[0] && !dark[5] && dark[9] && dark[10], "{dark:?}");
        assert!(is_dark(&ColourMap::BlueRed.at(0.0)) && is_dark(&ColourMap::BlueRed.at(1.0)));
    }
}
