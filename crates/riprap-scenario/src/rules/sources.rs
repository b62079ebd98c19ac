//! Rules of charges, explosives and the splitting of blocks.

use riprap_core::rhythm::Every;

use super::Rules;
use crate::language::{
    Around, CouplingWord, GasCavity, Place, Point3, PressureCavity, Refine, Scenario, Segment,
    Source, span_of,
};
use crate::quantity::Name;
use crate::words::WordOr;

impl Rules {
    pub(super) fn sources(&mut self, scenario: &Scenario) {
        for (name, source) in scenario.sources.iter() {
            match source {
                Source::GasCavity(gas) => self.gas(name, gas),
                Source::PressureCavity(cavity) => self.pressure_cavity(name, cavity),
            }
        }
        for refine in &scenario.refine {
            self.refine(refine, scenario);
        }
    }

    fn gas(&mut self, name: &Name, gas: &GasCavity) {
        let of = format!("sources.{name}.gas_cavity");
        if let Some(line) = &gas.line {
            self.segment(line);
        }
        if let Some(WordOr::Word(CouplingWord::Fitted, span)) = &gas.coupling
            && gas.centre.is_none()
        {
            let message = format!("{of} cannot be fitted");
            let help = "only a charge with `centre` can be; write coupling = { scaled = 0.667 }";
            self.error("source.fitted", span, message, help);
        }
    }

    fn pressure_cavity(&mut self, name: &Name, cavity: &PressureCavity) {
        if let Some(line) = &cavity.line {
            self.segment(line);
        }
        self.time_function(&name.span, Some(&cavity.pressure));
    }

    fn segment(&mut self, line: &Segment) {
        let si = |point: &Point3| [point[0].si(), point[1].si(), point[2].si()];
        if self.values_sound && si(&line.from) == si(&line.to) {
            let message = "this line has no length: its ends are the same point".to_owned();
            let help = "give two points, or `centre` for a concentrated charge";
            self.error("value.order", &span_of(&line.to), message, help);
        }
    }

    pub(super) fn around(&mut self, around: &Around) {
        match around {
            Around::Source(_) | Around::Point(_) => {}
            Around::Place(place, _) => match &**place {
                Place::Line(line) => self.segment(line),
                Place::Plane(plane) => self.normal(&plane.normal),
                Place::Box(region) => self.region(region),
                Place::Ball(_) | Place::All(_) => {}
            },
        }
    }

    fn refine(&mut self, refine: &Refine, scenario: &Scenario) {
        let span = refine.octree.around.span().clone();
        self.around(&refine.octree.around);
        match refine.octree.levels {
            Some(_) => {}
            None if fitted_charge(&refine.octree.around, scenario) => {}
            None => {
                let message = "the key `levels` is missing in refine.octree".to_owned();
                let help = "write for example levels = 3; only around a charge with fitted \
                            coupling it can be found";
                self.error("key.missing", &span, message, help);
            }
        }
        let Some(during) = &refine.during else { return };
        if let Some(every) = &during.every {
            match every.read() {
                Every::Steps(_) => {}
                Every::Time(_) | Every::Phase | Every::Never => {
                    let message = "`every` of refine.during is a number of steps".to_owned();
                    let help = "write for example every = \"50 steps\"";
                    self.error("value.time", &every.span, message, help);
                }
            }
        }
    }
}

/// Whether this is the name of a charge whose cells are fitted.
fn fitted_charge(around: &Around, scenario: &Scenario) -> bool {
    let Around::Source(name) = around else {
        return false;
    };
    match scenario.sources.get(name.as_str()) {
        Some(Source::GasCavity(gas)) => gas.is_fitted(),
        Some(Source::PressureCavity(_)) | None => false,
    }
}
