//! Whether the numbers of a state that was read mean something: a checkpoint may have been made by hand.

use riprap_core::numbers::{below, one_each};

use super::world::World;

impl World {
    /// Looks at every number that stands for a block, a row, a material, a bar or a node.
    ///
    /// # Errors
    /// The first that stands for nothing, in words.
    pub fn sound(&self) -> Result<(), String> {
        let blocks = self.setup.blocks.len();
        for (what, length) in [
            ("motions", self.bodies.len()),
            ("reference positions", self.reference.len()),
            ("reference angles", self.reference_angle.len()),
            ("marks of life", self.alive.len()),
            ("prescribed motions", self.motion.len()),
        ] {
            one_each(what, length, blocks)?;
        }
        self.setup_is_sound()?;
        below("water table", self.water.map(u32::from), self.setup.water.len())?;
        let pairs = self.pairs.iter().flat_map(|pair| [pair.i, pair.j]);
        let general = self.general.iter().flat_map(|pair| [pair.i, pair.j]);
        let bonds = self.bonds.iter().flat_map(|bond| [bond.i, bond.j]);
        below("block", pairs.chain(general).chain(bonds), blocks)?;
        let rows = self.bonds.iter().map(|bond| u32::from(bond.row));
        below("interface", rows, self.setup.interfaces.len())?;
        for bolt in &self.bolts {
            let sides = bolt.dowels.iter().flat_map(|dowel| &dowel.sides);
            let pins = bolt.pins.iter().chain(sides).map(|pin| pin.block);
            below("block", pins, blocks)?;
            let bars = bolt.dowels.iter().map(|dowel| dowel.bar);
            below("bar", bars, bolt.chain.bars.len())?;
            below("bolt", [bolt.number], self.setup.bolts.len())?;
        }
        let Some(seepage) = &self.seepage else {
            return Ok(());
        };
        let faces = seepage.faces.iter();
        let of_faces = faces.clone().map(|face| face.block);
        let conduits = seepage.conduits.iter();
        let of_conduits = conduits.clone().flat_map(|conduit| conduit.blocks);
        below("block", of_conduits.chain(of_faces), blocks)?;
        let nodes = conduits.flat_map(|conduit| conduit.nodes);
        let nodes = nodes.chain(faces.flat_map(|face| face.nodes));
        below("node of the seepage", nodes, seepage.nodes.len())
    }

    fn setup_is_sound(&self) -> Result<(), String> {
        let setup = &self.setup;
        let (blocks, materials) = (setup.blocks.len(), setup.materials.len());
        let of_blocks = setup.blocks.iter().map(|block| u32::from(block.material));
        below("material", of_blocks, materials)?;
        one_each("pairs of materials", setup.pair_table.len(), materials * materials)?;
        let rows = setup.pair_table.iter().map(|row| u32::from(*row));
        below("interface", rows, setup.interfaces.len())?;
        let supports = setup.supports.iter().flat_map(|support| &support.blocks);
        let loads = setup.loads.iter().flat_map(|load| &load.blocks);
        let groups = setup.groups.iter().flat_map(|group| &group.blocks);
        below("block", supports.chain(loads).chain(groups).copied(), blocks)?;
        let accounts = setup.loads.iter().filter_map(|load| load.account);
        below("account", accounts.map(u32::from), setup.accounts.len())
    }
}
