use super::*;

fn pipe(a: u32, b: u32, conductance: f64) -> Pipe {
    Pipe { ends: [a, b], conductance }
}

/// Three joints each way: lines 0, 1, 2 from left to right with unit conductance for each of four stretches, upright ones between them.
fn lattice(closed: Option<usize>) -> Network {
    let node = |line: u32, k: u32| 5 * line + k;
    let mut pipes = Vec::new();
    for line in 0..3 {
        pipes.extend((0..4).map(|k| pipe(node(line, k), node(line, k + 1), 1.0)));
    }
    for k in 1..4 {
        pipes.extend((0..2).map(|line| pipe(node(line, k), node(line + 1, k), 1.0)));
    }
    if let Some(closed) = closed {
        pipes[closed].conductance = 0.0;
    }
    let edge = |n: u32| match n % 5 {
        0 => Edge::Head(1.0),
        4 => Edge::Head(0.0),
        _ => Edge::Inside,
    };
    Network { heights: vec![-10.0; 15], edges: (0..15).map(edge).collect(), pipes }
}

/// What comes in on the left.
fn through(network: &Network) -> f64 {
    let flow = network.steady();
    assert!(flow.is_found(), "{flow:?}");
    [0, 4, 8].map(|k| flow.rates[k]).iter().sum()
}

#[test]
fn a_network_of_joints_carries_what_kirchhoff_says() {
    assert!((through(&lattice(None)) - 0.75).abs() < 1e-11);
    // The last stretch of the middle line is closed.
    assert!((through(&lattice(Some(7))) - 182.0 / 281.0).abs() < 1e-11);
}

#[test]
fn a_part_that_no_water_reaches_is_dry() {
    let network = Network {
        heights: vec![0.0, 1.0, 2.0, 3.0],
        edges: vec![Edge::Head(5.0), Edge::Inside, Edge::Inside, Edge::Outlet(3.0)],
        pipes: vec![pipe(0, 1, 1.0), pipe(2, 3, 1.0)],
    };
    let flow = network.steady();
    assert!((flow.pressures[1] - 4.0).abs() < 1e-12);
    assert_eq!(flow.pressures[2..], [0.0, 0.0]);
    assert_eq!(flow.rates, [0.0, 0.0]);
}

/// A rectangular dam of `n` cells each way, 10 m high and wide: water 8 m deep on the left, 2 m on the right where the wall above the water lets it
/// out; closed below.
fn dam(n: usize) -> (Network, Vec<usize>) {
    let side = 10.0;
    let step = side / n as f64;
    let node = |i: usize, j: usize| (i * (n + 1) + j) as u32;
    let (mut pipes, mut inlets) = (Vec::new(), Vec::new());
    for i in 0..=n {
        for j in 0..=n {
            if i < n {
                if i == 0 {
                    inlets.push(pipes.len());
                }
                // The lowest joint stands for half a cell.
                let width = if j == 0 { 0.5 } else { 1.0 };
                pipes.push(pipe(node(i, j), node(i + 1, j), width / step));
            }
            if j < n && i > 0 && i < n {
                pipes.push(pipe(node(i, j), node(i, j + 1), 1.0 / step));
            }
        }
    }
    let height = |j: usize| j as f64 * step;
    let edge = |i: usize, j: usize| {
        if i == 0 && height(j) <= 8.0 {
            Edge::Head(8.0)
        } else if i == n && height(j) <= 2.0 {
            Edge::Head(2.0)
        } else if i == n || (j == n && i > 0) {
            Edge::Outlet(height(j))
        } else {
            Edge::Inside
        }
    };
    let all = || (0..=n).flat_map(|i| (0..=n).map(move |j| (i, j)));
    let network = Network {
        heights: all().map(|(_, j)| height(j)).collect(),
        edges: all().map(|(i, j)| edge(i, j)).collect(),
        pipes,
    };
    (network, inlets)
}

/// Dupuit's rate through a dam with upright walls is exact (Charny 1951): `k (h1^2 - h2^2)/(2 l)`, with `k = 1/step` here. So it is in a lattice whose
/// water levels are levels of nodes.
#[test]
fn free_surface_of_a_dam() {
    for n in [10, 20, 40] {
        let (network, inlets) = dam(n);
        let flow = network.steady();
        assert!(flow.is_found(), "{n}: {} after {}", flow.left, flow.turns);
        let rate: f64 = inlets.iter().map(|k| flow.rates[*k]).sum();
        let exact = n as f64 / 10.0 * (64.0 - 4.0) / 20.0;
        assert!((rate / exact - 1.0).abs() < 1e-9, "{n}: {rate} {exact}");
        // The wall lets water out above the lower water, and part of the dam stays dry.
        let wet = |i: usize| {
            let column = i * (n + 1)..(i + 1) * (n + 1);
            flow.pressures[column].iter().filter(|p| **p > 0.0).count()
        };
        assert!(wet(n - 1) as f64 > 0.3 * n as f64, "{}", wet(n - 1));
        assert!(wet(1) as f64 <= 0.8 * n as f64 && wet(n / 2) < wet(1));
        assert!(flow.pressures.iter().all(|p| *p >= 0.0));
    }
}

/// Standing water is level whatever the joints are, and nothing flows.
#[test]
fn standing_water_is_level() {
    let (mut network, _) = dam(20);
    let mut random = 1u64;
    for pipe in &mut network.pipes {
        random = random.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1);
        pipe.conductance *= 0.1 + (random >> 33) as f64 / 2e8;
    }
    for (edge, z) in network.edges.iter_mut().zip(&mut network.heights) {
        // Nodes lie beside the levels of the lattice.
        random = random.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1);
        *z += 0.2 * (random >> 33) as f64 / (1u64 << 31) as f64;
        *edge = match *edge {
            Edge::Inside => Edge::Inside,
            _ if *z <= 5.3 => Edge::Head(5.3),
            _ => Edge::Outlet(*z),
        };
    }
    let flow = network.steady();
    assert!(flow.is_found(), "{} after {}", flow.left, flow.turns);
    for (p, z) in flow.pressures.iter().zip(&network.heights) {
        assert!((p - (5.3 - z).max(0.0)).abs() < 1e-4, "{p} at {z}");
    }
    assert!(flow.rates.iter().all(|q| q.abs() < 1e-4));
    // A pipe through the level is wet as far as the level.
    for (pipe, ends) in network.pipes.iter().zip(&flow.ends) {
        let [a, b] = pipe.ends.map(|n| network.heights[n as usize]);
        if (a < 5.3) != (b < 5.3) && (a - b).abs() > 0.3 {
            let level = a + (b - a) * ends[0] / (ends[0] - ends[1]);
            assert!((level - 5.3).abs() < 1e-3, "{level} {ends:?}");
        }
    }
}

/// A dam whose joints conduct unlike each other over five decades, and lean.
fn unlike(n: usize, seed: u64) -> Network {
    let (mut network, _) = dam(n);
    let mut random = seed;
    let mut draw = || {
        random = random.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1);
        (random >> 33) as f64 / (1u64 << 31) as f64
    };
    for pipe in &mut network.pipes {
        pipe.conductance *= libm::pow(10.0, 5.0 * draw() - 2.5);
    }
    for (edge, z) in network.edges.iter().zip(&mut network.heights) {
        if *edge == Edge::Inside {
            *z += 5.6 / n as f64 * draw();
        }
    }
    network
}

/// What comes in goes out, and outlets let nothing in.
#[test]
fn unlike_joints_have_an_answer() {
    let small = (1..5).map(|seed| (14, seed));
    // 200 turns and more where sets turn in circles.
    for (n, seed) in small.chain([(20, 6), (40, 4)]) {
        let network = unlike(n, seed);
        let flow = network.steady();
        assert!(flow.is_found(), "{seed}: {} after {}", flow.left, flow.turns);
        assert!(flow.turns < 150, "{seed}: {} turns", flow.turns);
        let mut out = vec![0.0; network.heights.len()];
        for (pipe, rate) in network.pipes.iter().zip(&flow.rates) {
            out[pipe.ends[0] as usize] += rate;
            out[pipe.ends[1] as usize] -= rate;
        }
        let all: f64 = out.iter().map(|q| q.abs()).sum();
        for (out, edge) in out.iter().zip(&network.edges) {
            match edge {
                Edge::Inside => assert!(out.abs() < 1e-6 * all, "{seed}: {out} of {all}"),
                Edge::Outlet(_) => assert!(*out < 1e-6 * all),
                Edge::Head(_) => {}
            }
        }
    }
}

/// Where turns are never of use the sweeps find the same flow: what the proof of the end stands on.
#[test]
fn sweeps_alone_find_the_same_flow() {
    let (plain, _) = dam(6);
    for network in [lattice(None), plain, unlike(6, 3)] {
        let (flow, swept) = (network.steady(), Search::new(&network).find(0));
        assert!(swept.is_found(), "{} after {}", swept.left, swept.turns);
        for (p, q) in flow.pressures.iter().zip(&swept.pressures) {
            assert!((p - q).abs() < 1e-5, "{p} {q}");
        }
    }
}

/// What is not found is never passed off as found.
#[test]
fn a_flow_that_was_not_found_says_so() {
    let mut network = lattice(None);
    network.pipes[0].conductance = f64::INFINITY;
    assert!(!network.steady().is_found());
}

/// A wide joint below a bowl, and a rim over which what comes into the bowl must rise: no piece without a way out.
#[test]
fn a_bowl_overflows() {
    // Reservoir, bowl, rim, outlet.
    let network = Network {
        heights: vec![3.0, 0.0, 2.0, 1.0],
        edges: vec![Edge::Head(5.0), Edge::Inside, Edge::Inside, Edge::Outlet(1.0)],
        pipes: vec![pipe(0, 1, 1.0), pipe(1, 2, 100.0), pipe(2, 3, 100.0)],
    };
    let flow = network.steady();
    assert!(flow.is_found(), "{flow:?}");
    // p0 + 3 - p1 = 100 (p1 - 2) = 100 s, and the rim stays without pressure.
    assert!((flow.pressures[1] - 205.0 / 101.0).abs() < 1e-5, "{flow:?}");
    assert!((flow.rates[2] - 300.0 / 101.0).abs() < 1e-5, "{flow:?}");
    assert_eq!(flow.pressures[2], 0.0);
}

/// 100,000 joints: `cargo test --release -p riprap-core seepage -- --ignored --nocapture`.
#[test]
#[ignore = "measures time"]
fn time_of_many_joints() {
    for network in [dam(223).0, gently_unlike(223)] {
        let begin = std::time::Instant::now();
        let flow = network.steady();
        let pipes = network.pipes.len();
        println!("{pipes} joints: {} turns, {:?}", flow.turns, begin.elapsed());
        assert!(flow.is_found());
    }
}

/// Conductances over one decade, as of apertures that scatter by two, in a lattice that leans.
fn gently_unlike(n: usize) -> Network {
    let mut network = unlike(n, 1);
    let (even, _) = dam(n);
    for (pipe, even) in network.pipes.iter_mut().zip(&even.pipes) {
        pipe.conductance = even.conductance * libm::pow(pipe.conductance / even.conductance, 0.2);
    }
    network
}
