//! Blocks and traces from the files of other tools.

use riprap_keys::Keys;
use serde::Deserialize;

use crate::quantity::{Name, PositiveLength, Quantity};

/// Polygons of a file, each a block.
#[derive(Debug, Clone, PartialEq, Deserialize, Keys)]
#[serde(deny_unknown_fields)]
#[keys(one_of("dxf", "tess"))]
#[keys(needs("layers", "sagitta", when = "dxf", help = "only drawings have it: leave it out"))]
pub struct Polygons {
    /// Path of a DXF drawing (text or binary): its closed polylines. Each layer becomes a
    /// group of its blocks.
    pub dxf: Option<Name>,
    /// Path of a tessellation of Neper in two dimensions.
    pub tess: Option<Name>,
    /// What the length 1 in the file stands for, m. Default as a drawing says (`$INSUNITS`), else 1 m.
    pub unit: Option<Quantity<PositiveLength>>,
    /// Names of the layers of a drawing that are taken. Default all.
    pub layers: Option<Vec<Name>>,
    /// Largest distance of an arc of a drawing from the straight pieces it becomes, m. Default a hundredth of its radius.
    pub sagitta: Option<Quantity<PositiveLength>>,
}

/// Mapped joints. The part of a trace that ends within a block divides nothing and is left out.
#[derive(Debug, Clone, PartialEq, Deserialize, Keys)]
#[serde(deny_unknown_fields)]
#[keys(one_of("csv", "dxf"))]
#[keys(needs("layers", "sagitta", when = "dxf", help = "only drawings have it: leave it out"))]
pub struct Traces {
    /// Path of a CSV file, with the ends of a trace in each row: columns `x1_m`, `y1_m`, `x2_m`
    /// and `y2_m`.
    pub csv: Option<Name>,
    /// Path of a DXF drawing (text or binary): its lines and open polylines.
    pub dxf: Option<Name>,
    /// What the length 1 in the drawing stands for, m. Default as the drawing says (`$INSUNITS`), else 1 m.
    pub unit: Option<Quantity<PositiveLength>>,
    /// Names of the layers of the drawing that are taken. Default all.
    pub layers: Option<Vec<Name>>,
    /// Largest distance of an arc of the drawing from the straight pieces it becomes, m. Default a hundredth of its radius.
    pub sagitta: Option<Quantity<PositiveLength>>,
}
