//! Numbers with units: text -> SI value and dimension.

/// Exponents of kilogram, metre, second and radian.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Dim(pub [i8; 4]);

impl Dim {
    /// Pure number.
    pub const NONE: Dim = Dim([0, 0, 0, 0]);
    /// m
    pub const LENGTH: Dim = Dim([0, 1, 0, 0]);
    /// rad
    pub const ANGLE: Dim = Dim([0, 0, 0, 1]);
    /// kg/m3
    pub const DENSITY: Dim = Dim([1, -3, 0, 0]);
    /// Pa
    pub const PRESSURE: Dim = Dim([1, -1, -2, 0]);
    /// Pa/m
    pub const STIFFNESS_PER_AREA: Dim = Dim([1, -2, -2, 0]);
    /// s
    pub const TIME: Dim = Dim([0, 0, 1, 0]);
    /// m/s
    pub const VELOCITY: Dim = Dim([0, 1, -1, 0]);
    /// m/s2
    pub const ACCELERATION: Dim = Dim([0, 1, -2, 0]);
    /// rad/s
    pub const SPIN: Dim = Dim([0, 0, -1, 1]);
    /// rad/s2
    pub const SPIN_ACCELERATION: Dim = Dim([0, 0, -2, 1]);
    /// N, also J/m and N m/m
    pub const FORCE: Dim = Dim([1, 1, -2, 0]);
    /// N/m
    pub const FORCE_PER_LENGTH: Dim = Dim([1, 0, -2, 0]);
    /// 1/s
    pub const RATE: Dim = Dim([0, 0, -1, 0]);
}

/// Why a text is no quantity.
#[derive(Debug, Clone, PartialEq)]
pub struct UnitError {
    /// What is wrong.
    pub message: String,
    /// What to write instead.
    pub help: Option<String>,
}

/// SI value and dimension of a text such as `"16 GPa"`.
pub fn parse(text: &str) -> Result<(f64, Dim), UnitError> {
    let _ = text;
    Err(UnitError {
        message: "not yet".to_owned(),
        help: None,
    })
}
