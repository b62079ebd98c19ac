//! Whether the numbers of a state that was read mean something: a checkpoint may have been made by hand.

use riprap_core::numbers::{below, one_each};

use crate::flow::End;
use crate::setup::LoadKind;
use crate::state::deform::Deform;
use crate::state::world::World;

impl World {
    /// Looks at numbers that stand for blocks, classes, rows, materials, bars, nodes and bodies.
    ///
    /// # Errors
    /// The first that stands for nothing, in words.
    pub fn sound(&self) -> Result<(), String> {
        let blocks = self.setup.blocks.len();
        let [displacement, velocity] = [&self.bodies.displacement, &self.bodies.velocity];
        for list in displacement.iter().chain(velocity) {
            one_each("freedoms", list.len(), blocks)?;
        }
        for (what, length) in [
            ("reference positions", self.reference.len()),
            ("solids", self.solid.len()),
            ("rotations", self.turned.len()),
            ("marks of life", self.alive.len()),
            ("origins", self.lineage.len()),
            ("prescribed motions", self.motion.len()),
            ("largest speeds", self.peak_speed_squared.len()),
        ] {
            one_each(what, length, blocks)?;
        }
        below("class of solids", self.solid.iter().copied(), self.solids.len())?;
        below("water table", self.water.map(u32::from), self.setup.water.len())?;
        self.setup_is_sound()?;
        self.patches_are_sound(blocks)?;
        let faces = self.faces.iter().map(|face| face.block);
        let pairs = self.found.pairs.iter().flat_map(|pair| pair.ends);
        let held = self.found.held.iter().flat_map(|pair| pair.ends);
        let cavities = self.cavities.iter();
        let walls = cavities.clone().flat_map(|cavity| &cavity.walls);
        let walls = walls.map(|wall| wall.block);
        let removed = cavities.clone().flat_map(|cavity| &cavity.blocks).copied();
        let all = faces.chain(pairs).chain(held).chain(walls).chain(removed);
        below("block", all, blocks)?;
        let sources = cavities.map(|cavity| u32::from(cavity.source));
        below("source", sources, self.setup.sources.len())?;
        let boundaries = self.faces.iter().filter_map(|face| face.boundary);
        below("boundary", boundaries.map(u32::from), self.setup.boundaries.len())?;
        self.gas_is_sound(blocks)?;
        for bolt in &self.bolts {
            let sides = bolt.dowels.iter().flat_map(|dowel| &dowel.sides);
            let pins = bolt.pins.iter().chain(sides).map(|pin| pin.block);
            below("block", pins, blocks)?;
            let bars = bolt.dowels.iter().map(|dowel| dowel.bar);
            below("bar", bars, bolt.chain.bars.len())?;
            below("bolt", [bolt.number], self.setup.bolts.len())?;
        }
        match &self.deform {
            Some(deform) => self.deform_is_sound(deform, blocks),
            None => Ok(()),
        }
    }

    fn gas_is_sound(&self, blocks: usize) -> Result<(), String> {
        let Some(gas) = &self.gas else { return Ok(()) };
        let cells = gas.cracks.len() + gas.cavities.len();
        let network = &gas.network;
        one_each("masses of gas", gas.masses.len(), cells)?;
        one_each("ports", network.first.len(), network.ends.len() + 1)?;
        below("block", gas.cracks.iter().flat_map(|crack| crack.blocks), blocks)?;
        below("cavity", gas.cavities.iter().copied(), self.cavities.len())?;
        below("crack", network.ports.iter().map(|port| port.cell), gas.cracks.len())?;
        below("port", network.first.iter().copied(), network.ports.len() + 1)?;
        let of_ends = network.ends.iter().filter_map(|end| match end {
            End::Cell(cell) => Some(*cell),
            End::Inside | End::Air => None,
        });
        below("cell", of_ends, cells)
    }

    fn setup_is_sound(&self) -> Result<(), String> {
        let setup = &self.setup;
        let (blocks, materials) = (setup.blocks.len(), setup.materials.len());
        let of_blocks = setup.blocks.iter().map(|block| u32::from(block.material));
        below("material", of_blocks, materials)?;
        let names = setup.blocks.iter().map(|block| u32::from(block.name.base));
        below("name", names, setup.names.len())?;
        one_each("pairs of materials", setup.pair_table.len(), materials * materials)?;
        let rows = setup.pair_table.iter().map(|row| u32::from(*row));
        let bridges = setup.bridges.iter().map(|bridges| u32::from(bridges.row));
        below("interface", rows.chain(bridges), setup.interfaces.len())?;
        let supports = setup.supports.iter().flat_map(|support| &support.blocks);
        let loads = setup.loads.iter().flat_map(|load| &load.blocks);
        let groups = setup.groups.iter().flat_map(|group| &group.blocks);
        let holds = setup.deform.holds.iter().filter_map(|hold| hold.blocks.as_ref());
        let all = supports.chain(loads).chain(groups).chain(holds.flatten());
        below("block", all.copied(), blocks)?;
        for load in &setup.loads {
            if let LoadKind::Nodes { forces } = &load.kind {
                let deform = self.deform.as_deref();
                let body = |b: &u32| deform.and_then(|d| d.body(*b as usize));
                let least = load.blocks.iter().map(|b| body(b).map_or(0, |body| body.count)).min();
                let nodes = forces.iter().map(|(node, _)| *node);
                below("node", nodes, least.unwrap_or(0) as usize)?;
            }
        }
        let accounts = setup.loads.iter().filter_map(|load| load.account);
        below("account", accounts.map(u32::from), setup.accounts.len())
    }

    fn patches_are_sound(&self, blocks: usize) -> Result<(), String> {
        let (patches, count) = (&self.patches, self.patches.ends.len());
        below("block", patches.ends.iter().flatten().copied(), blocks)?;
        one_each("classes of patches", patches.class.len(), count)?;
        one_each("states of patches", patches.flags.len(), count)?;
        below("class of patches", patches.class.iter().copied(), self.classes.len())?;
        // Lists of which a model without what they hold has none.
        for (what, length) in [
            ("initial tractions", patches.prestress.len()),
            ("slips", patches.slip.len()),
            ("normal offsets", patches.normal_offset.len()),
            ("accumulated slips", patches.accumulated_slip.len()),
        ] {
            if length > 0 {
                one_each(what, length, count)?;
            }
        }
        let rows = self.classes.iter().map(|class| u32::from(class.row));
        below("interface", rows, self.setup.interfaces.len())?;
        let materials = self.classes.iter().flat_map(|class| class.materials);
        below("material", materials.map(u32::from), self.setup.materials.len())
    }

    fn deform_is_sound(&self, deform: &Deform, blocks: usize) -> Result<(), String> {
        let nodes = deform.nodes.place.len();
        one_each("displacements of nodes", deform.nodes.displacement.len(), nodes)?;
        one_each("velocities of nodes", deform.nodes.velocity.len(), nodes)?;
        let bodies = deform.bodies.iter().map(|body| body.block);
        let facets = deform.facets.iter().flat_map(|facet| facet.blocks);
        below("block", bodies.chain(facets), blocks)?;
        let ends = deform.bodies.iter();
        let ends = ends.map(|body| u64::from(body.first) + u64::from(body.count));
        let last = ends.max().unwrap_or(0);
        if last > nodes as u64 {
            return Err(format!("node {last} is out of range ({nodes})"));
        }
        let points = deform.facets.iter();
        let points = points.map(|facet| u64::from(facet.first) + u64::from(facet.count));
        let (last, points) = (points.max().unwrap_or(0), deform.points.len());
        if last > points as u64 {
            return Err(format!("point {last} is out of range ({points})"));
        }
        let surfaces = deform.surfaces.iter();
        below("body", surfaces.clone().map(|surface| surface.body), deform.bodies.len())?;
        let of_surfaces = surfaces.flat_map(|surface| &surface.nodes).map(|(node, _)| *node);
        let held = deform.holds.iter().map(|hold| hold.node);
        below("node", of_surfaces.chain(held), nodes)?;
        let rows = deform.facets.iter().map(|facet| u32::from(facet.row));
        below("interface", rows, self.setup.interfaces.len())
    }
}
