//! Stress of blocks in frames: its components as columns, and read back its principal values with their axes.
//!
//! Stress is positive in tension, Pa, in global axes. In space `stress_normal` is xx, yy, zz and `stress_shear` yz, zx, xy; in the
//! plane they are xx, yy and xy.

use riprap_geom::symmetric::principal_axes;
use riprap_geom::{Mat3, Vec3};

use super::Column;

/// Column of normal components.
pub const NORMAL: &str = "stress_normal";
/// Column of shear components.
pub const SHEAR: &str = "stress_shear";

/// Principal stresses of one block.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Principal {
    /// Values, Pa, tension positive, largest first. In the plane the last is that across the plane, which is not known: 0.
    pub values: [f64; 3],
    /// Unit vectors along them, global axes, right-handed; in the plane the last is z.
    pub axes: [Vec3; 3],
}

impl Principal {
    /// From the components in the plane, Pa.
    #[must_use]
    pub fn in_plane(xx: f64, yy: f64, xy: f64) -> Self {
        let (mean, half) = (0.5 * (xx + yy), 0.5 * (xx - yy));
        let radius = (half * half + xy * xy).sqrt();
        // Half the angle of (half, xy), without losing digits where it points back.
        let along = if radius == 0.0 {
            Vec3::X
        } else if half >= 0.0 {
            Vec3::new(radius + half, xy, 0.0).normalize()
        } else {
            let sign = if xy < 0.0 { -1.0 } else { 1.0 };
            Vec3::new(xy.abs(), sign * (radius - half), 0.0).normalize()
        };
        Principal {
            values: [mean + radius, mean - radius, 0.0],
            axes: [along, Vec3::new(-along.y, along.x, 0.0), Vec3::Z],
        }
    }
}

/// The two columns of stresses in space.
#[must_use]
pub fn in_space(stresses: &[Mat3]) -> [Column; 2] {
    let normal = |s: &Mat3| [s.x_axis.x, s.y_axis.y, s.z_axis.z];
    let shear = |s: &Mat3| [s.z_axis.y, s.x_axis.z, s.y_axis.x];
    let [normal, shear]: [Vec<[f64; 3]>; 2] =
        [stresses.iter().map(normal).collect(), stresses.iter().map(shear).collect()];
    [Column::vector3(NORMAL, "Pa", normal), Column::vector3(SHEAR, "Pa", shear)]
}

/// The two columns of stresses in the plane, each xx, yy, xy.
#[must_use]
pub fn in_plane(stresses: &[[f64; 3]]) -> [Column; 2] {
    let normal: Vec<[f64; 2]> = stresses.iter().map(|s| [s[0], s[1]]).collect();
    [
        Column::vector(NORMAL, "Pa", normal),
        Column::scalar(SHEAR, "Pa", stresses.iter().map(|s| s[2]).collect()),
    ]
}

/// Principal stresses of all blocks from the columns of a frame; `None` where they are not among them, as in runs of earlier versions.
#[must_use]
pub fn principal(columns: &[Column]) -> Option<Vec<Principal>> {
    let column = |name: &str| columns.iter().find(|c| c.name == name);
    let (normal, shear) = (column(NORMAL)?, column(SHEAR)?);
    let both = normal.data.chunks(normal.components);
    let both = both.zip(shear.data.chunks(shear.components));
    let one = |(n, s): (&[f64], &[f64])| match (n, s) {
        (&[xx, yy, zz], &[yz, zx, xy]) => {
            let m = Mat3::from_cols(
                Vec3::new(xx, xy, zx),
                Vec3::new(xy, yy, yz),
                Vec3::new(zx, yz, zz),
            );
            let (values, axes) = principal_axes(&m);
            Some(Principal { values, axes })
        }
        // A file keeps vectors of the plane with a third component.
        (&[xx, yy, ..], &[xy]) => Some(Principal::in_plane(xx, yy, xy)),
        _ => None,
    };
    both.map(one).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_plane_agrees_with_space() {
        let cases = [
            [1.0, -3.0, 0.5],
            [-3.0, 1.0, 0.5],
            [-3.0, 1.0, -0.5],
            [2.0, 2.0, -1.0],
            [-5.0, 0.0, 0.0],
            [0.0; 3],
        ];
        let plane = principal(&in_plane(&cases)).unwrap();
        for ([xx, yy, xy], p) in cases.iter().zip(&plane) {
            let m = Mat3::from_cols_array(&[*xx, *xy, 0.0, *xy, *yy, 0.0, 0.0, 0.0, 0.0]);
            for k in 0..2 {
                let left = m * p.axes[k] - p.values[k] * p.axes[k];
                assert!(left.length() < 1e-14, "{xx} {yy} {xy}: {left}");
            }
            assert_eq!(*p, Principal::in_plane(*xx, *yy, *xy));
            assert!(p.values[0] >= p.values[1] && p.axes[0].cross(p.axes[1]).z > 0.999);
        }
    }

    #[test]
    fn columns_of_space_come_back() {
        let m = Mat3::from_cols_array(&[-4.0, 1.0, 0.5, 1.0, -2.0, 0.25, 0.5, 0.25, 3.0]);
        let [p] = principal(&in_space(&[m])).unwrap()[..] else {
            panic!("one block has one stress")
        };
        for k in 0..3 {
            let left = m * p.axes[k] - p.values[k] * p.axes[k];
            assert!(left.length() < 1e-14);
        }
        assert_eq!(principal(&in_space(&[m])[..1]), None);
    }
}
