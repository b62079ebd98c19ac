"""What hybrid_p_wave_45.toml should show: a packet of plane waves with one period along y at the junction of two half spaces.

Medium 1 (x < X) is the lattice of rigid blocks as a continuum, C11 = M, C12 = 0, C44 = G; medium 2 is isotropic. Displacements and
tractions agree at the junction; for each frequency that gives the two reflected and the two transmitted waves.
Prints the reflection of the plane wave at 45 degrees and the largest pressures of the packet at the gauge. Needs NumPy.
"""

import numpy as np

RHO, YOUNG, NU = 2500.0, 30e9, 0.25
ROWS, CYCLES, JUNCTION, GAUGE = 12, 16, 160.0, 64.5
M = YOUNG * (1 - NU) / ((1 + NU) * (1 - 2 * NU))
G = YOUNG / (2 * (1 + NU))
LATTICE, ISOTROPIC = (M, 0.0, G), (M, M - 2 * G, G)
KY = np.pi / ROWS
# Frequency of the lattice at kx = ky, its dispersion included.
OMEGA = 2 * np.sin(KY / 2) * np.sqrt((M + 2 * G) / RHO)


def waves(c, omega):
    """P and S wave that leave towards +x: wave number along x and direction of motion (time factor exp(-i omega t))."""
    c11, c12, c44 = c
    p, s = c11 * KY**2 - RHO * omega**2, c44 * KY**2 - RHO * omega**2
    squares = np.roots([c11 * c44, c11 * p + c44 * s - ((c12 + c44) * KY) ** 2, p * s]).astype(complex)
    out = []
    for k in np.sqrt(squares):
        k = -k if k.imag < 0 else k
        k = -np.conj(k) if omega < 0 else k
        u = np.array([-(c12 + c44) * k * KY, c11 * k * k + s])
        if np.abs(u).max() < 1e-6 * M * KY**2:
            u = np.array([c44 * k * k + p, -(c12 + c44) * k * KY])
        out.append((k, u / np.linalg.norm(u)))
    return sorted(out, key=lambda wave: abs(wave[0]))


def state(c, k, u):
    """Displacement and traction on a plane across x (over i)."""
    c11, c12, c44 = c
    return np.array([u[0], u[1], c11 * k * u[0] + c12 * KY * u[1], c44 * (k * u[1] + KY * u[0])])


def back(u):
    """Direction of motion of the same wave towards -x."""
    return np.array([-u[0], u[1]])


def reflected(one, two, k, u):
    """Amplitudes of reflected P and S for an incident wave of unit amplitude."""
    columns = [state(LATTICE, -k1, back(u1)) for k1, u1 in one]
    columns += [-state(ISOTROPIC, k2, u2) for k2, u2 in two]
    return np.linalg.solve(np.array(columns).T, -state(LATTICE, k, u))[:2]


def packet():
    """Pressures at the gauge over time: incident, reflected."""
    steps, last = 1 << 15, 0.8
    t = np.arange(steps) * last / steps
    shape = np.where(t < 2 * np.pi * CYCLES / OMEGA, 0.5 * (1 - np.cos(OMEGA * t / CYCLES)), 0.0)
    drive = [np.fft.ifft(shape * np.sin(OMEGA * t)), np.fft.ifft(1j * shape * np.cos(OMEGA * t))]
    omegas = 2 * np.pi * np.fft.fftfreq(steps, last / steps)
    size = abs(drive[0]) + abs(drive[1])
    incident, echo = np.zeros(steps, complex), np.zeros(steps, complex)
    for n in np.flatnonzero((size > 1e-5 * size.max()) & (omegas != 0)):
        omega = omegas[n]
        one, two = waves(LATTICE, omega), waves(ISOTROPIC, omega)
        moved = np.array([drive[0][n], drive[1][n]]) / (-1j * omega)
        for (k, u), a in zip(one, np.linalg.solve(np.array([u for _, u in one]).T, moved)):
            incident[n] -= M / 3 * a * np.exp(1j * k * GAUGE) * 1j * (k * u[0] + KY * u[1])
            for (k1, u1), r in zip(one, reflected(one, two, k, u)):
                way = np.exp(1j * (k * JUNCTION + k1 * (JUNCTION - GAUGE)))
                echo[n] -= M / 3 * a * r * way * 1j * (-k1 * back(u1)[0] + KY * u1[1])
    # The gauge is half a block above the axis.
    return [np.fft.fft(x).real * np.cos(KY / 2) for x in (incident, echo)]


if __name__ == "__main__":
    omega = KY * np.sqrt((M + 2 * G) / RHO)
    one, two = waves(LATTICE, omega), waves(ISOTROPIC, omega)
    print("plane wave at 45 degrees: P", *abs(reflected(one, two, *one[0]))[:1], "S", *abs(reflected(one, two, *one[0]))[1:])
    print("largest pressure of the packet, Pa: incident, reflected", *(x.max() for x in packet()))
