//! Scenario to SI numbers: block generation, material and interface tables, resolved plan.
