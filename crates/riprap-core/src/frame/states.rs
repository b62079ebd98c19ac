//! The table `final_states.csv`: where blocks are and how they move, as `start.csv` of a scene reads it.

use crate::field::number;

/// State of a block.
#[derive(Clone, Debug, PartialEq)]
pub struct BlockState {
    /// Name of the block.
    pub name: String,
    /// The numbers of its row, SI, global axes: place of the centroid, attitude against the shape of the scene, velocity and spin.
    pub numbers: Vec<f64>,
}

/// Columns in the plane, after the name.
pub const PLANAR: &str = "x_m,y_m,angle_rad,vx_m_s,vy_m_s,spin_rad_s";

/// Columns in space, after the name.
pub const SPATIAL: &str = "x_m,y_m,z_m,qw,qx,qy,qz,vx_m_s,vy_m_s,vz_m_s,wx_rad_s,wy_rad_s,wz_rad_s";

/// The table.
#[must_use]
pub fn csv(columns: &str, states: &[BlockState]) -> String {
    let mut text = format!("block,{columns}\n");
    for state in states {
        text.push_str(&state.name);
        for x in &state.numbers {
            text.push(',');
            text.push_str(&number(*x));
        }
        text.push('\n');
    }
    text
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_row_has_a_number_for_each_column() {
        let state =
            BlockState { name: "a.1".to_owned(), numbers: vec![1.0, -2.5, 1e-9, 0.0, 0.1, 3.0] };
        let text = csv(PLANAR, &[state]);
        assert_eq!(text.lines().nth(1), Some("a.1,1,-2.5,1e-9,0,0.1,3"));
        assert_eq!(text.lines().map(|l| l.split(',').count()).collect::<Vec<_>>(), [7, 7]);
    }
}
