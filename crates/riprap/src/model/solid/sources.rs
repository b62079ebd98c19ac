//! Charges, other cavities, and the splitting of blocks.

use riprap_geom::Vec3;

use super::global;
use super::pattern::span_of_pattern;
use super::places::region_of;
use crate::laws::explosive::{Explosive, ExplosiveError, Products};
use crate::laws::jwl::{self, Jwl};
use crate::model::builder::Builder;
use crate::model::memory;
use crate::model::summary::Charge;
use crate::plan::Every;
use crate::scenario::language::{
    self, Around, CouplingWord, GasCavity, JwlConstants, JwlSet, Point3, PressureCavity, Refine,
    Segment, VentingCracks, span_of,
};
use crate::scenario::read::{Provenance, with_unit};
use crate::scenario::vectors::unit;
use crate::scenario::words::WordOr;
use crate::scenario::{Diagnostic, Name, Span};
use crate::spatial::divisible::Divisible;
use crate::spatial::setup::{
    BlockSpec, CavityPressure, Coupling, Cracks, Criterion, During, Hole, Place, Refinement,
    Region, Shape, Source, Venting,
};
use riprap_core::flow::Friction;

/// Exponent that keeps the force on the wall of the cavity.
const WALL_FORCE: f64 = 2.0 / 3.0;
/// Steps between two looks at a criterion of splitting.
const EVERY: u64 = 50;
/// Most blocks that splitting makes.
const MOST_PARTS: f64 = 1e8;
/// Beyond this ratio of the volumes of removed blocks and charge a coupling by faces means little.
const UNLIKE: f64 = 4.0;
/// How uneven the wave of a charge is in bricks whose joints fail: measured at 6 widths of the charge in `scenes/blast/even_wave_bricks.toml`.
const LATTICE: &str = "measured at 6 widths of a charge 2.9 times the mean peak speed of 26 directions along the axes and 0.3 times it along the diagonals of space";

impl Builder<'_> {
    pub(super) fn sources(&mut self) {
        for (name, source) in self.parsed.scenario.sources.iter() {
            match source {
                language::Source::GasCavity(gas) => self.gas(name, gas),
                language::Source::PressureCavity(cavity) => self.pressure(name, cavity),
            }
        }
    }

    fn gas(&mut self, name: &Name, gas: &GasCavity) {
        let Some(explosive) = self.products(name, gas) else {
            return;
        };
        let path = format!("sources.{name}.gas_cavity");
        let delay = self.reading(path.as_str(), gas).delay();
        let coupling = self.coupling(name, gas);
        let venting = match &gas.venting {
            None => None,
            Some(language::Venting::Heave(height)) => Some(Venting::Heave { height: height.si() }),
            Some(language::Venting::Time(time)) => Some(Venting::Time {
                start: time.start.si(),
                span: self.reading(format!("{path}.venting.time"), time).span(),
            }),
            Some(language::Venting::Cracks(cracks)) => self.cracks(name, cracks),
        };
        let push = |mass: f64| CavityPressure::Gas { explosive, mass, coupling, venting };
        let origin = self.spatial.origin;
        let (holes, span) = match (&gas.pattern, &gas.line, &gas.decks) {
            (Some(pattern), ..) => {
                (self.holes(name, pattern, explosive.density()), span_of_pattern(pattern))
            }
            (None, Some(line), Some(decks)) => (self.decks(name, line, decks), span_of(&line.from)),
            (None, _, _) => {
                // A missing mass is reported by the rules of the language.
                let Some(mass) = &gas.mass else { return };
                let place = self.source_place(name, &gas.centre, &gas.line, &gas.group);
                let Some(place) = place else { return };
                let Some(hole) = self.hole(name, gas, &explosive, &place, None) else { return };
                self.enter_source(name.text.clone(), place, delay, push(mass.si()), hole);
                return;
            }
        };
        for (number, hole) in (1..).zip(holes.unwrap_or_default()) {
            let place = Place::Line { from: hole.from - origin, to: hole.to - origin };
            let name_of = format!("{name}.{number}");
            if self.in_rock(&place, &name_of, &span) {
                let above = (number, hole.stemmed);
                let Some(own) = self.hole(name, gas, &explosive, &place, Some(above)) else {
                    return;
                };
                self.enter_source(name_of, place, delay + hole.delay, push(hole.mass), own);
            }
        }
    }

    /// How gas flows in the cracks of a charge.
    fn cracks(&mut self, name: &Name, said: &VentingCracks) -> Option<Venting> {
        let mut read = self.reading(format!("sources.{name}.gas_cavity.venting.cracks"), said);
        let (viscosity, roughness) = (read.viscosity(), read.roughness());
        let friction = Friction { viscosity, roughness, inertia: read.inertia() };
        let (aperture, widest) = (read.aperture(), read.aperture_max());
        let air = read.air_pressure();
        if widest < aperture {
            let message = format!(
                "the largest aperture of the cracks of `{name}` is {}, and that of a closed one {}",
                with_unit(widest, "m"),
                with_unit(aperture, "m")
            );
            let help = "give an `aperture_max` that is not below `aperture`";
            self.error_at("source.cracks", name, message, help);
            return None;
        }
        Some(Venting::Cracks(Cracks { friction, aperture, widest, air }))
    }

    /// Refuses gas in cracks that the network does not know.
    fn cracks_are_one(&mut self) {
        let entered = |source: &Source| match source.push {
            CavityPressure::Gas { explosive, venting: Some(Venting::Cracks(rules)), .. } => {
                Some((source.name.clone(), explosive, rules))
            }
            CavityPressure::Gas { .. } | CavityPressure::Pressure { .. } => None,
        };
        let all: Vec<_> = self.spatial.sources.iter().filter_map(entered).collect();
        let Some((first, explosive, rules)) = all.first() else { return };
        let at = |name: &str| self.span_of_source(name);
        let soft = !self.spatial.deform.sets.is_empty();
        let periodic = self.spatial.periodic.iter().any(Option::is_some);
        let why = match (soft, periodic) {
            (true, _) => Some("models with deformable blocks"),
            (_, true) => Some("periodic models"),
            (false, false) => None,
        };
        if let Some(why) = why {
            let message = format!("the gas of `{first}` cannot enter cracks in {why}");
            let help = "`venting.cracks` needs rigid blocks and a model without periods; leave it out to keep the gas in its cavity";
            return self.error_at("source.cracks", at(first), message, help);
        }
        if let Some((other, ..)) = all.iter().find(|(_, e, r)| e != explosive || r != rules) {
            let message = format!(
                "the gas of `{other}` and of `{first}` enters the same cracks, with another explosive or other constants of `venting.cracks`"
            );
            let help = "give charges with `venting.cracks` one explosive and the same constants";
            return self.error_at("source.cracks", at(other), message, help);
        }
        let pressure = |(name, explosive, rules): &(String, Products, Cracks)| {
            let adiabat = explosive.adiabat(1.0).ok()?;
            (adiabat.pressure(adiabat.v0()) <= rules.air).then(|| name.clone())
        };
        if let Some(name) = all.iter().find_map(pressure) {
            let message = format!("the pressure of the air is above that of the gas of `{name}`");
            let help = "give a lower `venting.cracks.air_pressure`";
            self.error_at("source.cracks", at(&name), message, help);
        }
    }

    fn pressure(&mut self, name: &Name, cavity: &PressureCavity) {
        let mut read = self.reading(format!("sources.{name}.pressure_cavity"), cavity);
        let delay = read.delay();
        let Some(time) = self.time_function(&cavity.pressure) else {
            return;
        };
        if let Some(place) = self.source_place(name, &cavity.centre, &cavity.line, &cavity.group) {
            let push = CavityPressure::Pressure { time };
            self.enter_source(name.text.clone(), place, delay, push, Hole::default());
        }
    }

    fn enter_source(
        &mut self,
        name: String,
        place: Place,
        delay: f64,
        push: CavityPressure,
        hole: Hole,
    ) {
        self.warn_of_air(&name, &place, &push);
        self.directory.sources.push(name.clone());
        self.spatial.sources.push(Source { name, place, delay, push, hole });
    }

    /// The explosive in numbers, if they make sense.
    fn products(&mut self, name: &Name, gas: &GasCavity) -> Option<Products> {
        let (said, path) = match &gas.explosive {
            WordOr::Word(of, _) => {
                let named = self.parsed.scenario.explosives.get(of.as_str())?;
                (named, format!("explosives.{of}"))
            }
            WordOr::Table(said, _) => (said, format!("sources.{name}.gas_cavity.explosive")),
        };
        let products = match &said.jwl {
            Some(jwl) => Products::Jwl(self.jwl(name, said, jwl, &path)?),
            None => {
                let mut read = self.reading(path, said);
                // What is missing is reported by the rules of the language.
                Products::TwoStage(Explosive {
                    density: read.density()?,
                    detonation_velocity: read.detonation_velocity()?,
                    heat: read.heat_of_explosion()?,
                    gamma: read.gamma(),
                    gamma_low: read.gamma_low_or(4.0 / 3.0, Provenance::Default, "4/3"),
                })
            }
        };
        let Err(error) = products.validate() else {
            return Some(products);
        };
        let span = match &error {
            ExplosiveError::Exponents { .. } => {
                let gamma = said.gamma.as_ref().or(said.gamma_low.as_ref());
                gamma.map(|gamma| &gamma.span)
            }
            ExplosiveError::Heat { .. } => said.heat_of_explosion.as_ref().map(|heat| &heat.span),
            ExplosiveError::NotPositive { .. } => None,
            ExplosiveError::Jwl => said.jwl.as_ref().map(WordOr::span),
        };
        let help = match &error {
            ExplosiveError::Jwl => {
                "check that a, b, r1, r2, omega and energy are of one set, and their units"
            }
            _ => "check density, detonation_velocity and heat_of_explosion and their units",
        };
        self.explosive_error(span.unwrap_or(&name.span), format!("`{name}`: {error}"), help);
        None
    }

    /// Constants of the equation of state of Jones, Wilkins and Lee.
    fn jwl(
        &mut self,
        name: &Name,
        said: &language::Explosive,
        constants: &WordOr<JwlSet, JwlConstants>,
        path: &str,
    ) -> Option<Jwl> {
        let constants = match (constants, &said.density) {
            (WordOr::Word(set, _), None) => set.constants(),
            (WordOr::Word(set, _), Some(density)) => {
                let own = set.constants().density;
                let message = format!("`{name}`: the published constants are of {own} kg/m3");
                let help = "leave `density` out, or give the constants of your explosive: jwl = { a = \"49.5 GPa\", ... }";
                self.explosive_error(&density.span, message, help);
                return None;
            }
            (WordOr::Table(given, span), density) => {
                let Some(density) = density else {
                    let message = format!("`{name}`: the constants of `jwl` have no density");
                    let help =
                        "give the density that they belong to, for example density = \"931 kg/m3\"";
                    self.explosive_error(span, message, help);
                    return None;
                };
                let density = density.si();
                let mut read = self.reading(format!("{path}.jwl"), given);
                let [a, b, energy] = [read.a(), read.b(), read.energy()];
                Jwl { density, a, b, r1: read.r1(), r2: read.r2(), omega: read.omega(), energy }
            }
        };
        if let Some(given) = said.detonation_velocity.as_ref().filter(|_| constants.is_sound()) {
            let own = constants.chapman_jouguet().velocity;
            if (given.si() / own - 1.0).abs() > jwl::AGREES {
                let message = format!(
                    "`{name}`: the detonation velocity is {}, but the constants of `jwl` detonate at {own:.0} m/s",
                    with_unit(given.si(), "m/s")
                );
                let help = "leave `detonation_velocity` out, or check that the constants are of this explosive";
                self.explosive_error(&given.span, message, help);
                return None;
            }
        }
        Some(constants)
    }

    /// Several charges of one explosive report it once.
    fn explosive_error(&mut self, span: &Span, message: String, help: &str) {
        let error = Diagnostic::error("explosive", message).at(span.clone()).help(help);
        if !self.found.contains(&error) {
            self.found.push(error);
        }
    }

    fn coupling(&mut self, name: &Name, gas: &GasCavity) -> Coupling {
        let key = format!("sources.{name}.gas_cavity.coupling");
        let from = Provenance::given(gas.coupling.is_some());
        let (coupling, text, why) = match &gas.coupling {
            _ if gas.is_fitted() => (
                Coupling::Scaled { exponent: WALL_FORCE },
                "fitted".to_owned(),
                "the cells of the grid have the volume of the charge",
            ),
            Some(WordOr::Word(CouplingWord::Coupled, _)) => {
                (Coupling::Coupled, "coupled".to_owned(), "")
            }
            Some(WordOr::Word(CouplingWord::Decoupled, _)) => {
                (Coupling::Decoupled, "decoupled".to_owned(), "")
            }
            Some(WordOr::Table(scale, _)) => {
                let exponent = scale.scaled.si();
                let text = format!("scaled {}", scale.scaled.raw);
                (Coupling::Scaled { exponent }, text, "")
            }
            Some(WordOr::Word(CouplingWord::Fitted, _)) | None => (
                Coupling::Scaled { exponent: WALL_FORCE },
                "scaled 2/3".to_owned(),
                "keeps the force on the cavity wall",
            ),
        };
        self.explain(key, text, from, why);
        coupling
    }

    /// Where a source lies; `None` after an error.
    fn source_place(
        &mut self,
        name: &Name,
        centre: &Option<Point3>,
        line: &Option<Segment>,
        group: &Option<Name>,
    ) -> Option<Place> {
        let origin = self.spatial.origin;
        let (place, span) = match (centre, line, group) {
            (Some(point), _, _) => {
                let centre = global(point) - origin;
                (Place::Point { centre }, span_of(point))
            }
            (None, Some(line), _) => {
                let from = global(&line.from) - origin;
                let to = global(&line.to) - origin;
                (Place::Line { from, to }, span_of(&line.from))
            }
            (None, None, Some(group)) => {
                let blocks = self.directory.blocks(group);
                let blocks = self.take(blocks.map_err(|error| vec![*error]))?;
                (Place::Blocks { blocks }, group.span.clone())
            }
            // Reported by the rules of the language.
            (None, None, None) => return None,
        };
        self.in_rock(&place, name.as_str(), &span).then_some(place)
    }

    /// Whether a source touches blocks that can be taken away.
    fn in_rock(&mut self, place: &Place, name: &str, span: &Span) -> bool {
        let touched = match (place, region_of(place)) {
            (Place::Blocks { blocks }, _) => blocks.clone(),
            (_, Some(region)) => self.touching(&region),
            (Place::Point { .. } | Place::Line { .. }, None) => Vec::new(),
        };
        if touched.is_empty() {
            let message = format!("`{name}` lies outside all blocks");
            let help = "check its coordinates; a source removes the blocks that it touches";
            self.error_at("source.outside", span.clone(), message, help);
            return false;
        }
        if let Some(&block) = touched.iter().find(|&&block| self.held(block)) {
            let held = self.directory.name(block);
            let message = format!("`{name}` touches block `{held}`, which is fixed");
            let help = "move the source, or hold the model at its boundaries";
            self.error_at("source.fixed", span.clone(), message, help);
            return false;
        }
        true
    }

    pub(super) fn refinements(&mut self) {
        for refine in &self.parsed.scenario.refine {
            let during = refine.during.as_ref().and_then(|said| self.during(said));
            let levels = self.levels(refine);
            let Some(regions) = self.regions(refine).filter(|_| levels > 0) else {
                continue;
            };
            for around in regions {
                let span = refine.octree.around.span();
                if !self.can_be_split(&around, during.is_some(), span)
                    || during.is_none() && !self.has_room_for(&around, levels, span)
                {
                    continue;
                }
                self.spatial.refinements.push(Refinement { around, levels, during });
            }
        }
    }

    fn levels(&mut self, refine: &Refine) -> u8 {
        let found = match &refine.octree.around {
            Around::Source(name) => self.fitted_levels.get(name.as_str()).copied(),
            Around::Point(_) | Around::Place(..) => None,
        };
        match (refine.octree.levels, found, &refine.octree.around) {
            (Some(levels), _, _) => levels,
            (None, Some(levels), Around::Source(name)) => {
                let key = format!("refine.{name}.levels");
                let why = "this changes the cells of the grid least";
                self.explain(key, levels.to_string(), Provenance::Derived, why);
                levels
            }
            // Reported by the rules of the language.
            (None, _, _) => 1,
        }
    }

    /// Where blocks are split; the holes of a pattern are several places.
    fn regions(&mut self, refine: &Refine) -> Option<Vec<Region>> {
        let origin = self.spatial.origin;
        let region = match &refine.octree.around {
            Around::Point(point) => Region::Point(self.local(point.xyz())),
            Around::Source(name) => {
                let pattern = format!("{name}.");
                let sources = self.spatial.sources.iter();
                let own: Vec<&Source> = sources
                    .filter(|s| s.name == name.text || s.name.starts_with(&pattern))
                    .collect();
                if own.is_empty() {
                    return self.cells_of_group(name);
                }
                let regions = own.iter().flat_map(|source| match &source.place {
                    Place::Blocks { blocks } => self.boxes_of(blocks, 0.0),
                    place @ (Place::Point { .. } | Place::Line { .. }) => {
                        region_of(place).into_iter().collect::<Vec<_>>()
                    }
                });
                return Some(regions.collect());
            }
            Around::Place(place, _) => match &**place {
                language::Place::Line(line) => {
                    Region::Line(global(&line.from) - origin, global(&line.to) - origin)
                }
                language::Place::Plane(plane) => {
                    let normal = Vec3::from(unit(&plane.normal)?);
                    Region::Plane(global(&plane.at) - origin, normal)
                }
                language::Place::Ball(ball) => {
                    Region::Ball(global(&ball.centre) - origin, ball.radius.si())
                }
                language::Place::Box(region) => {
                    Region::Box(self.local(region.min.xyz()), self.local(region.max.xyz()))
                }
                language::Place::All(_) => Region::All,
            },
        };
        Some(vec![region])
    }

    /// Whether blocks touch a region and can be split: all of them before a run, some of them during one.
    fn can_be_split(&mut self, region: &Region, during: bool, span: &Span) -> bool {
        let touched = self.touching(region);
        let (blocks, sets) = (&self.spatial.blocks, &self.spatial.deform.sets);
        let deforms = |b: &u32| sets.iter().any(|set| set.blocks.binary_search(b).is_ok());
        let stays = |b: &u32| deforms(b) || Divisible::of(&blocks[*b as usize].shape).is_none();
        let whole: Vec<u32> = touched.iter().copied().filter(|b| stays(b)).collect();
        if let Some(&block) = whole.first() {
            let name = self.directory.name(block);
            let message = match deforms(&block) {
                true => format!(
                    "block `{name}` is deformable; deformable blocks are cut, not split into eight"
                ),
                false => format!("block `{name}` cannot be split into eight similar parts"),
            };
            let which = "only rigid blocks with six faces in three parallel pairs can be split, in any orientation: bricks, also with `rotate`, and \
                         blocks bounded by three joint sets";
            if !during || whole.len() == touched.len() {
                let help = format!("{which}; choose a region that touches only such blocks");
                self.error_at("refine.shape", span.clone(), message, help);
                return false;
            }
            let message = format!(
                "{message}: {} of the {} blocks in this region stay whole",
                whole.len(),
                touched.len()
            );
            self.warn_at("refine.shape", span.clone(), message, which);
        }
        if touched.is_empty() {
            let help = "check its coordinates and their units";
            self.error_at("refine.nothing", span.clone(), "no block lies in this region", help);
        }
        !touched.is_empty()
    }

    /// Whether there is room for the blocks that a refinement makes: before any is made, since a slip of the pen in `levels` would fill the
    /// memory.
    fn has_room_for(&mut self, region: &Region, levels: u8, span: &Span) -> bool {
        let most = memory::most_bricks().min(MOST_PARTS);
        let mut count = 0.0;
        for shape in self.spatial.blocks.iter().map(|block| &block.shape) {
            let block = Divisible::of(shape);
            count += block.map_or(1.0, |block| block.parts_around(region, levels, most - count));
            if count > most && !matches!(region, Region::All) {
                break;
            }
        }
        if count <= most {
            return true;
        }
        let exact = matches!(region, Region::All);
        let message = format!(
            "{levels} levels here make {} {} blocks; at most {most:.1e} are allowed",
            if exact { "about" } else { "more than" },
            if exact { format!("{count:.1e}") } else { format!("{most:.1e}") },
        );
        let help = "give fewer `levels` (each level splits a block into eight) or a smaller region";
        self.error_at("refine.many", span.clone(), message, help);
        false
    }

    fn during(&mut self, said: &language::During) -> Option<During> {
        let (criterion, above) = match (&said.stress, &said.strain_rate, &said.broken) {
            (Some(stress), _, _) => (Criterion::Stress, stress.si()),
            (None, Some(rate), _) => (Criterion::StrainRate, rate.si()),
            (None, None, Some(share)) => (Criterion::Broken, share.si()),
            // Reported by the rules of the language.
            (None, None, None) => return None,
        };
        let every = match said.every.as_ref().map(language::Every::read) {
            Some(Every::Steps(steps)) => steps,
            Some(Every::Time(_) | Every::Phase | Every::Never) | None => EVERY,
        };
        Some(During { criterion, above, every })
    }

    /// Warns of a charge in a lattice of bricks whose joints can fail.
    fn warn_of_lattice(&mut self, source: usize) {
        let Source { name, place, .. } = &self.spatial.sources[source];
        let touched = match (place, region_of(place)) {
            (Place::Blocks { blocks }, _) => blocks.clone(),
            (_, Some(region)) => self.touching(&region),
            (Place::Point { .. } | Place::Line { .. }, None) => Vec::new(),
        };
        let (blocks, laws) = (&self.spatial.blocks, &self.spatial.interfaces);
        let materials = self.spatial.materials.len();
        let fails = |block: &u32| {
            let BlockSpec { shape, material, name, .. } = &blocks[*block as usize];
            let row = self.spatial.pair_table[usize::from(*material) * (materials + 1)];
            // One brick alone is no lattice.
            name.number > 0
                && matches!(shape, Shape::Brick { .. })
                && laws[usize::from(row)].joint.strength.is_some()
        };
        if !touched.iter().any(fails) {
            return;
        }
        let message = format!(
            "`{name}` lies in a lattice of bricks whose joints can fail: its wave is a cross ({LATTICE})"
        );
        let help = "grid.cells with `graded` carries it more evenly; bricks split 1 to 8 are what the source paper does";
        let name = name.clone();
        let span = self.span_of_source(&name);
        let warning = Diagnostic::warning("source.lattice", message).at(span).help(help);
        self.found.push(warning);
    }

    /// Volumes of charges and of the blocks they replace, for the summary, with a warning where they
    /// have little to do with each other.
    pub(super) fn source_volumes(&mut self) {
        self.cracks_are_one();
        for k in 0..self.spatial.sources.len() {
            let source = &self.spatial.sources[k];
            let (cells, cavity) = self.removed(&source.place);
            let (mass, volume, scaled) = match &source.push {
                CavityPressure::Gas { explosive, mass, coupling, .. } => {
                    let scaled = matches!(coupling, Coupling::Scaled { .. });
                    (Some(*mass), Some(mass / explosive.density()), scaled)
                }
                CavityPressure::Pressure { .. } => (None, None, false),
            };
            let name = source.name.clone();
            let ratio = volume.map(|volume| cavity / volume);
            if let Some(ratio) = ratio
                && scaled
                && !(1.0 / UNLIKE..=UNLIKE).contains(&ratio)
            {
                let message = format!(
                    "`{name}` has the volume {}, the {cells} blocks that it replaces {}: {} times",
                    with_unit(volume.unwrap_or(0.0), "m3"),
                    with_unit(cavity, "m3"),
                    with_unit(ratio, ""),
                );
                let help = "refine the blocks around it so that the finest match its volume: the pressure depends on it";
                let span = self.span_of_source(&name);
                self.warn_at("source.volume", span, message, help);
            }
            if mass.is_some() {
                self.warn_of_lattice(k);
            }
            self.summary.charges.push(Charge { name, mass, volume, blocks: cells, cavity, ratio });
        }
    }
}
