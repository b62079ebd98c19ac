# %% [markdown]
# # Coupling with a flow code
#
# A lid of rock lies on a joint through which water flows. A small finite-difference code of one's own finds the pressure along the joint from its aperture
# (cubic law); the pressure lifts and tilts the lid, which changes the aperture. Each side runs as it is: riprap moves the lid, NumPy solves
# the flow, and a callback hands apertures one way and forces the other.
#
# The end is known: a rigid lid on a joint of stiffness k makes the aperture linear, a(x) = A + B x, for which the pressure has a closed form, and A and B follow
# from the balance of forces and of moments.
#
# Open it in any editor that knows the percent format (VS Code, PyCharm, Jupyter with jupytext), or run it: `python coupled_flow.py`.

# %%
import numpy as np

import riprap

LENGTH, STIFFNESS = 4.0, 25e6  # m, Pa/m
APERTURE = 0.5e-3  # of the joint under the weight of the lid alone, m
INLET = 10e3  # pressure at x = 0, Pa; nothing at the other end
VISCOSITY = 1e-3  # Pa s


def rectangle(name, size, corner):
    shape = {"size": [f"{s} m" for s in size], "corner": [f"{c} m" for c in corner]}
    return {"name": name, "material": "rock", "rectangle": shape}


scenario = riprap.Scenario(
    {
        "riprap": 1,
        "title": "A lid on a joint with flowing water",
        "space": {"planar": {"gravity": ["0 m/s2", "-10 m/s2"]}},
        "materials": {"rock": {"density": "2500 kg/m3"}},
        "interfaces": {"default": {"normal_stiffness": f"{STIFFNESS} Pa/m", "friction_angle": "35 deg", "damping_ratio": 0.5}},
        "blocks": [rectangle("floor", (LENGTH + 2, 1), (-1, -1)), rectangle("lid", (LENGTH, 1), (0, 0))],
        "supports": [{"on": {"block": "floor"}, "fixed": {}}],
        "phases": [
            {"name": "dry", "until": {"time": "0.5 s"}, "damping": {"local": 0.5}},
            {"name": "flow", "until": {"time": "1.5 s"}, "damping": {"local": 0.5}},
        ],
    }
)

# %% [markdown]
# ## The flow code
#
# Steady flow in cells of equal length: between two neighbours as much flows as the harmonic mean of their transmissivities a^3/(12 mu) lets through. It
# knows nothing of blocks.

# %%
CELLS = 200
x = (np.arange(CELLS) + 0.5) * LENGTH / CELLS


def flow(aperture):
    """Pressure in the cells (Pa), and what flows in and out (m2/s)."""
    conductance = aperture**3 / (12 * VISCOSITY) / (LENGTH / CELLS)
    between = 2 / (1 / conductance[1:] + 1 / conductance[:-1])
    ends = 2 * conductance[[0, -1]]
    matrix = np.diag(np.r_[ends[0], between] + np.r_[between, ends[1]]) - np.diag(between, 1) - np.diag(between, -1)
    source = np.zeros(CELLS)
    source[0] = ends[0] * INLET
    pressure = np.linalg.solve(matrix, source)
    return pressure, ends[0] * (INLET - pressure[0]), ends[1] * pressure[-1]


# %% [markdown]
# ## The coupling
#
# Every 20 steps: the lower side of the lid gives the aperture, the flow code the pressure, and its resultant goes back as a force and a moment on the lid. The floor
# is fixed and needs none.

# %%
rest = {}
told = {}


def lower_side(sim):
    corners = np.asarray(sim.frame().corners(1))
    low = corners[np.argsort(corners[:, 1])[:2]]
    left, right = low[np.argsort(low[:, 0])]
    slope = (right[1] - left[1]) / (right[0] - left[0])
    return left[1] + slope * (x - left[0])


def couple(sim):
    if sim.phase != "flow":
        rest["side"] = lower_side(sim)
        return
    aperture = APERTURE + lower_side(sim) - rest["side"]
    pressure, inflow, outflow = flow(aperture)
    middle = float(np.asarray(sim.frame().corners(1))[:, 0].mean())
    width = LENGTH / CELLS
    force, moment = pressure.sum() * width, (pressure * (x - middle)).sum() * width
    sim.set_force("lid", (0, force), moment)
    told.update(aperture=aperture, pressure=pressure, force=force, moment=moment, inflow=inflow, outflow=outflow)


def go():
    with riprap.Simulation(scenario, threads=1) as sim:
        sim.run(couple, every=20)
        return sim.state_hash, sim.value("block.speed", of="lid").value


state, speed = go()

# %% [markdown]
# ## The closed form
#
# With a(x) = A + B x the flow is q = p0 / (12 mu I(L)) and the pressure p = p0 (1 - I(x)/I(L)), I(x) the integral of 1/a^3 from 0 to x,
# (1/A^2 - 1/a(x)^2)/(2 B). The joint takes what the water lifts: A and B follow from force and moment by k L and k L^3/12.

# %%
fine = (np.arange(20000) + 0.5) * LENGTH / 20000
a, b = APERTURE, 0.0
for _ in range(200):
    opened = a + b * fine
    integral = (1 / a**2 - 1 / opened**2) / (2 * b) if b else fine / a**3
    whole = (1 / a**2 - 1 / (a + b * LENGTH) ** 2) / (2 * b) if b else LENGTH / a**3
    p = INLET * (1 - integral / whole)
    lift, tilt = p.mean() * LENGTH, (p * (fine - LENGTH / 2)).mean() * LENGTH
    b = tilt / (STIFFNESS * LENGTH**3 / 12)
    a = APERTURE + lift / (STIFFNESS * LENGTH) - b * LENGTH / 2
through = INLET / (12 * VISCOSITY * whole)

print(f"lift {told['force']:.1f} N/m, closed form {lift:.1f}; moment {told['moment']:.1f} N, closed form {tilt:.1f}")
print(f"aperture {1e3 * told['aperture'][0]:.4f} to {1e3 * told['aperture'][-1]:.4f} mm, closed form {1e3 * a:.4f} to {1e3 * (a + b * LENGTH):.4f}")
print(f"flow {told['inflow']:.4e} m2/s, closed form {through:.4e}; with the first aperture it were {INLET * APERTURE**3 / (12 * VISCOSITY * LENGTH):.4e}")
assert abs(told["inflow"] - told["outflow"]) < 1e-9 * told["inflow"], "what flows in flows out"
assert abs(told["force"] - lift) < 2e-3 * lift and abs(told["moment"] - tilt) < 2e-3 * abs(tilt)
assert abs(told["inflow"] - through) < 5e-3 * through and speed < 1e-6

# %% [markdown]
# The same script gives the same bits.

# %%
assert go()[0] == state
