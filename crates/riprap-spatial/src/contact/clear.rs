//! How deep a convex body that is not in the model yet would lie in the blocks that are: the question before a block is added.
//!
//! A pair of bodies lies in each other as deep as the diameter of the largest ball in what they have in common, as found contacts are judged. Blocks
//! of glued parts are looked at part by part, deformable ones by tetrahedron, terrain facet by facet. A look at all blocks whose spheres meet
//! costs less than a step, so that no list is needed.

use riprap_geom::polyhedron::Polyhedron;
use riprap_geom::{Mat3, Vec3};

use crate::kernel::peak::{Peak, peak};
use crate::kernel::planes::{self, Planes};
use crate::kernel::terrain::Under;
use crate::kernel::{Body, Image, Pose, Reached, Shape, Terrain, turn};
use crate::setup::{self, Solid};
use crate::state::scratch::Scratch;
use crate::state::world::World;

/// Depth that round-off of coordinates explains, as a share of the cube root of the smaller volume: that which scenes may have at the start.
const ACCEPTED: f64 = 1e-6;
/// How far the body looks for terrain, over its radius.
const REACH: f64 = 1.0;
/// Corners of the faces of a tetrahedron of positive volume, anticlockwise seen from outside.
const SIDES: [[u32; 3]; 4] = [[0, 2, 1], [0, 1, 3], [1, 2, 3], [2, 0, 3]];

/// A body that looks for blocks in its way.
struct Look<'a> {
    shape: &'a Shape,
    /// Its centroid, m.
    at: Vec3,
    /// m³.
    volume: f64,
    planes: Planes,
    normals: Vec<Vec3>,
    deepest: Option<(u32, f64)>,
}

/// The living block in which a body with this shape, not turned, at `at` (m) lies deepest, and how deep, m; `None` where it lies in none by more than
/// round-off. `number` is that which the body would have: in a periodic model it can meet itself.
pub(crate) fn deepest(
    world: &World,
    scratch: &Scratch,
    (shape, volume): (&Shape, f64),
    at: Vec3,
    number: u32,
) -> Option<(u32, f64)> {
    let (planes, normals) = (Planes::default(), Vec::new());
    let mut look = Look { shape, at, volume, planes, normals, deepest: None };
    for b in (0..world.alive.len()).filter(|b| world.alive[*b]) {
        let volume = world.solid_of(b).volume;
        if world.is_terrain(b) {
            look.ground(world, scratch, b);
        } else if world.deforms(b) {
            look.tetrahedra(world, scratch, b);
        } else if look.near(world, world.pose(b).position, world.solid_of(b).radius) {
            for part in parts(&world.setup.blocks[b].shape) {
                look.part(world, (b as u32, volume), &part, world.pose(b), world.reference[b]);
            }
        }
    }
    for image in images(world, Vec3::ZERO).filter(|image| *image != Image::SELF) {
        let place = image.place(at, &world.setup.periodic);
        look.meet((number, volume), shape, Pose::at(place));
    }
    look.deepest
}

/// The convex parts of a shape that is no terrain.
fn parts(shape: &setup::Shape) -> Vec<Polyhedron> {
    match shape {
        setup::Shape::Brick { centre, half } => vec![Polyhedron::brick(*centre, *half)],
        setup::Shape::Polyhedron(solid) => vec![solid.polyhedron()],
        setup::Shape::Glued(parts) => parts.iter().map(Solid::polyhedron).collect(),
        setup::Shape::Terrain(_) => Vec::new(),
    }
}

/// Images of a block that lies so far (m) from the body that can be near it: the nearest one and those around it along the periods.
fn images(world: &World, way: Vec3) -> impl Iterator<Item = Image> {
    let periods = world.setup.periodic;
    let nearest = Image::nearest(way, &periods);
    let along = move |k: usize| if periods[k].is_some() { -1..=1 } else { 0..=0 };
    along(0).flat_map(move |x| {
        along(1).flat_map(move |y| along(2).map(move |z| nearest.plus(Image([x, y, z]))))
    })
}

impl Look<'_> {
    /// Whether the sphere of a block can meet that of the body.
    fn near(&self, world: &World, position: Vec3, radius: f64) -> bool {
        let periods = &world.setup.periodic;
        let reach = self.shape.radius + radius;
        images(world, self.at - position)
            .any(|image| (image.place(position, periods) - self.at).length() < reach)
    }

    /// A convex part of a block whose frame, about `centre` (m) at the start, stands at a pose.
    fn part(
        &mut self,
        world: &World,
        block: (u32, f64),
        part: &Polyhedron,
        pose: Pose,
        centre: Vec3,
    ) {
        let own = part.moments().centroid;
        // A part without room for a ball shares none.
        let Ok(shape) = Shape::new(part, own) else {
            return;
        };
        let position = pose.place(own - centre);
        for image in images(world, self.at - position) {
            let position = image.place(position, &world.setup.periodic);
            self.meet(block, &shape, Pose { position, ..pose });
        }
    }

    fn meet(&mut self, block: (u32, f64), other: &Shape, pose: Pose) {
        if (pose.position - self.at).length() >= self.shape.radius + other.radius {
            return;
        }
        self.normals.clear();
        let turned = turn(other, pose.rotation, &mut self.normals);
        let own = Body {
            shape: self.shape,
            normals: &self.shape.normals,
            turn: Mat3::IDENTITY,
            position: self.at,
        };
        let body =
            Body { shape: other, normals: &self.normals, turn: turned, position: pose.position };
        self.planes.gather_all([&own, &body], planes::origin(&own, &body));
        if let Peak::Overlap { depth, .. } =
            peak(&self.planes, 4.0 * (self.shape.radius + other.radius))
        {
            self.take(block, 2.0 * depth);
        }
    }

    fn ground(&mut self, world: &World, scratch: &Scratch, b: usize) {
        let known = &scratch.desk.terrain;
        let made;
        let terrain = match known.blocks.iter().position(|g| *g as usize == b) {
            Some(k) => &known.grounds[k],
            None => {
                let setup::Shape::Terrain(surface) = &world.setup.blocks[b].shape else {
                    return;
                };
                made = Terrain::new(surface.field());
                &made
            }
        };
        let body = Body {
            shape: self.shape,
            normals: &self.shape.normals,
            turn: Mat3::IDENTITY,
            position: self.at,
        };
        let mut under = Under::default();
        let depth = match under.find(terrain, &body, REACH) {
            Reached::Apart(_) => return,
            Reached::FullyPenetrated(depth) => depth,
            Reached::Touching => under.facets.iter().map(|on| on.sums.depth).fold(0.0, f64::max),
        };
        self.take((b as u32, self.volume), depth);
    }

    fn tetrahedra(&mut self, world: &World, scratch: &Scratch, b: usize) {
        let (Some(deform), Some(work)) = (world.deform.as_deref(), scratch.deform.as_deref())
        else {
            return;
        };
        let Some(body) = deform.body(b) else {
            return;
        };
        let nodes = &deform.nodes;
        let place = |n: u32| {
            let n = (body.first + n) as usize;
            nodes.place[n] + Vec3::from_array(nodes.displacement[n])
        };
        for tet in &work.class(body).mesh.tets {
            let mut corners = tet.map(place);
            let [p, q, r, s] = corners;
            if (q - p).cross(r - p).dot(s - p) < 0.0 {
                corners.swap(1, 2);
            }
            let centre = 0.25 * corners.iter().sum::<Vec3>();
            let radius = corners.iter().map(|v| (*v - centre).length()).fold(0.0, f64::max);
            if self.near(world, centre, radius) {
                let faces = SIDES.iter().map(|side| side.to_vec()).collect();
                let part = Polyhedron { vertices: corners.to_vec(), faces };
                let block = (b as u32, world.solid_of(b).volume);
                self.part(world, block, &part, Pose::at(centre), centre);
            }
        }
    }

    /// Notes a depth (m) in a block with its volume (m³).
    fn take(&mut self, (block, volume): (u32, f64), depth: f64) {
        let accepted = ACCEPTED * libm::cbrt(self.volume.min(volume));
        if depth > accepted && self.deepest.is_none_or(|(_, most)| depth > most) {
            self.deepest = Some((block, depth));
        }
    }
}
