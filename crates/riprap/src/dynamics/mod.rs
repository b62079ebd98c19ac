//! Clock, integrators, damping, time functions, convergence.
