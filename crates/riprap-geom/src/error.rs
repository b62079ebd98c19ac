use crate::Vec2;

/// What can be wrong with an outline, or with the numbers that shall make blocks.
///
/// Vertices and edges are counted from 0; edge `i` runs from vertex `i` to vertex `i + 1`.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
pub enum GeomError {
    /// An outline needs three different vertices.
    #[error("the outline has {count} distinct vertices; it needs at least 3")]
    TooFewVertices {
        /// Different vertices found.
        count: usize,
    },
    /// Refused so that the quadratic tests end.
    #[error("the outline has {count} vertices; at most {cap} are allowed")]
    TooManyVertices {
        /// Vertices found.
        count: usize,
        /// Most allowed.
        cap: usize,
    },
    /// A coordinate is NaN or infinite, or too large to be squared.
    #[error("vertex {vertex} has non-finite coordinates ({x}, {y})")]
    NonFinite {
        /// Vertex number.
        vertex: usize,
        /// Its x.
        x: f64,
        /// Its y.
        y: f64,
    },
    /// All vertices on one line.
    #[error("the outline encloses no area ({area:e} m2): its vertices lie on one line")]
    ZeroArea {
        /// Area found.
        area: f64,
    },
    /// Two edges cross or touch.
    #[error(
        "the outline crosses itself: edge {edge_a} (from vertex {edge_a}) meets edge {edge_b} \
         near ({:.6}, {:.6})", .at.x, .at.y
    )]
    SelfIntersecting {
        /// First edge.
        edge_a: usize,
        /// Second edge.
        edge_b: usize,
        /// Where, about.
        at: Vec2,
    },
    /// The outline runs back on itself.
    #[error("the outline turns back on itself at vertex {vertex} ({:.6}, {:.6})", .at.x, .at.y)]
    Spike {
        /// Vertex at the tip.
        vertex: usize,
        /// Where.
        at: Vec2,
    },
    /// A parameter out of range.
    #[error("{what} is {value}; it must be {need}")]
    BadNumber {
        /// Which parameter.
        what: &'static str,
        /// Its value.
        value: f64,
        /// What it must be, to follow "it must be".
        need: &'static str,
    },
    /// The request would make more than the cap.
    #[error("this would make about {count:.3e} {what}; at most {cap} are allowed")]
    TooMany {
        /// Of what.
        what: &'static str,
        /// How many it would make.
        count: f64,
        /// Most allowed.
        cap: usize,
    },
    /// Sites could not be moved so that all edges of their cells are long enough.
    #[error(
        "{count} cell edges are still shorter than {wanted} m after {rounds} rounds of moving the sites; the shortest is {shortest:.3e} m long"
    )]
    ShortEdges {
        /// Edges that are too short.
        count: usize,
        /// The shortest, m.
        shortest: f64,
        /// What was asked for, m.
        wanted: f64,
        /// Rounds of moving.
        rounds: usize,
    },
    /// A packing does not fit.
    #[error(
        "{wanted} blocks of up to {size} m do not fit: the region holds {capacity} without overlap"
    )]
    DoesNotFit {
        /// Blocks asked for.
        wanted: usize,
        /// Largest block, m.
        size: f64,
        /// Blocks that fit.
        capacity: usize,
    },
    /// The cutting segments could not be turned into blocks.
    #[error(
        "the cuts near ({:.6}, {:.6}) are too close together; change the seed or the spacing slightly", .at.x, .at.y
    )]
    Arrangement {
        /// Where, about.
        at: Vec2,
    },
}

/// `Ok` if `value` is finite and `good`, else `BadNumber`.
pub(crate) fn demand(
    what: &'static str,
    value: f64,
    good: bool,
    need: &'static str,
) -> Result<(), GeomError> {
    if value.is_finite() && good { Ok(()) } else { Err(GeomError::BadNumber { what, value, need }) }
}
