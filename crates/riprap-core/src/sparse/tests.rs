use super::*;

/// Numbers from -1 to 1.
struct Chance(u64);

impl Chance {
    fn next(&mut self) -> f64 {
        self.0 =
            self.0.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        (self.0 >> 11) as f64 / (1u64 << 52) as f64 - 1.0
    }

    fn below(&mut self, limit: usize) -> usize {
        ((0.5 + 0.5 * self.next()) * limit as f64) as usize % limit
    }

    fn block(&mut self) -> Block {
        std::array::from_fn(|_| std::array::from_fn(|_| self.next()))
    }

    /// Different bodies.
    fn pairs(&mut self, bodies: usize, count: usize) -> Vec<[u32; 2]> {
        let mut pairs = Vec::new();
        while pairs.len() < count && bodies > 1 {
            let pair = [self.below(bodies) as u32, self.below(bodies) as u32];
            if pair[0] != pair[1] {
                pairs.push(pair);
            }
        }
        pairs
    }
}

/// As contacts make it: `T' K T` with a semidefinite `K` for each pair, and a small mass.
struct System {
    diagonal: Vec<Block>,
    pairs: Vec<([u32; 2], Block)>,
}

/// `a' b`.
fn product(a: &Block, b: &Block) -> Block {
    std::array::from_fn(|r| std::array::from_fn(|c| (0..SIZE).map(|k| a[k][r] * b[k][c]).sum()))
}

impl System {
    fn new(chance: &mut Chance, bodies: usize, pairs: &[[u32; 2]]) -> Self {
        let mut mass = Block::default();
        for k in 0..SIZE {
            mass[k][k] = 0.1;
        }
        let mut system = Self { diagonal: vec![mass; bodies], pairs: Vec::new() };
        for pair in pairs {
            let [a, b] = [chance.block(), chance.block()];
            add(&mut system.diagonal[pair[0] as usize], &product(&a, &a));
            add(&mut system.diagonal[pair[1] as usize], &product(&b, &b));
            system.pairs.push((*pair, product(&a, &b)));
        }
        system
    }

    fn matrix(&self) -> Matrix {
        let mut matrix = Matrix::default();
        let pairs: Vec<_> = self.pairs.iter().map(|(pair, _)| *pair).collect();
        matrix.fit(self.diagonal.len(), &pairs);
        self.fill(&mut matrix);
        matrix
    }

    fn fill(&self, matrix: &mut Matrix) {
        for (body, block) in self.diagonal.iter().enumerate() {
            matrix.add_diagonal(body, block);
        }
        for (k, (_, block)) in self.pairs.iter().enumerate() {
            matrix.add_pair(k, block);
        }
    }

    fn dense(&self) -> Vec<Vec<f64>> {
        let mut a = vec![vec![0.0; SIZE * self.diagonal.len()]; SIZE * self.diagonal.len()];
        for r in 0..SIZE {
            for c in 0..SIZE {
                for (body, block) in self.diagonal.iter().enumerate() {
                    a[SIZE * body + r][SIZE * body + c] += block[r][c];
                }
                for ([i, j], block) in &self.pairs {
                    let [i, j] = [SIZE * *i as usize + r, SIZE * *j as usize + c];
                    a[i][j] += block[r][c];
                    a[j][i] += block[r][c];
                }
            }
        }
        a
    }
}

/// Cholesky's method as in a textbook; the error is the row without a positive pivot.
fn dense_solution(mut a: Vec<Vec<f64>>, b: &[[f64; SIZE]]) -> Result<Vec<f64>, usize> {
    let n = a.len();
    let mut x: Vec<f64> = b.iter().flatten().copied().collect();
    for c in 0..n {
        for r in c..n {
            let sum: f64 = (0..c).map(|k| a[r][k] * a[c][k]).sum();
            a[r][c] -= sum;
        }
        if a[c][c] <= 0.0 {
            return Err(c);
        }
        let root = a[c][c].sqrt();
        for row in &mut a[c..] {
            row[c] /= root;
        }
        let sum: f64 = (0..c).map(|k| a[c][k] * x[k]).sum();
        x[c] = (x[c] - sum) / a[c][c];
    }
    for c in (0..n).rev() {
        let sum: f64 = (c + 1..n).map(|k| a[k][c] * x[k]).sum();
        x[c] = (x[c] - sum) / a[c][c];
    }
    Ok(x)
}

fn sides(chance: &mut Chance, bodies: usize) -> Vec<[f64; SIZE]> {
    (0..bodies).map(|_| chance.block()[0]).collect()
}

/// Largest difference in terms of the largest number.
fn difference(a: impl Iterator<Item = f64>, b: impl Iterator<Item = f64>) -> f64 {
    let (mut largest, mut scale) = (0.0_f64, 0.0_f64);
    for (a, b) in a.zip(b) {
        largest = largest.max((a - b).abs());
        scale = scale.max(b.abs());
    }
    if largest.is_nan() { f64::NAN } else { largest / scale }
}

#[test]
fn equals_the_dense_solution() {
    let mut chance = Chance(1);
    for bodies in 1..=30 {
        // Isolated bodies, trees, and full graphs in which pairs repeat in both senses.
        for count in [0, bodies / 2, 2 * bodies, bodies * bodies] {
            let pairs = chance.pairs(bodies, count);
            let system = System::new(&mut chance, bodies, &pairs);
            let b = sides(&mut chance, bodies);
            let exact = dense_solution(system.dense(), &b).unwrap();
            let mut matrix = system.matrix();
            matrix.factor().unwrap();
            let mut x = b.clone();
            matrix.solve(&mut x);
            let error = difference(x.into_iter().flatten(), exact.into_iter());
            assert!(error < 1e-11, "{bodies} bodies, {count} pairs: {error:e}");
        }
    }
}

#[test]
fn numbering_does_not_matter() {
    let mut chance = Chance(2);
    for bodies in [2, 7, 25, 80] {
        let pairs = chance.pairs(bodies, 2 * bodies);
        let system = System::new(&mut chance, bodies, &pairs);
        let b = sides(&mut chance, bodies);
        let mut x = b.clone();
        let mut matrix = system.matrix();
        matrix.factor().unwrap();
        matrix.solve(&mut x);
        // Body k gets number (3 k + 1) mod n, which is one to one where 3 does not divide n; pairs come backwards.
        assert!(bodies % 3 != 0);
        let renumbered = |k: usize| (3 * k + 1) % bodies;
        let mut other = System { diagonal: system.diagonal.clone(), pairs: Vec::new() };
        let mut y = b.clone();
        for k in 0..bodies {
            other.diagonal[renumbered(k)] = system.diagonal[k];
            y[renumbered(k)] = b[k];
        }
        for (pair, block) in system.pairs.iter().rev() {
            let [i, j] = pair.map(|k| renumbered(k as usize) as u32);
            let opposite = std::array::from_fn(|r| std::array::from_fn(|c| block[c][r]));
            other.pairs.push(([j, i], opposite));
        }
        let mut matrix = other.matrix();
        matrix.factor().unwrap();
        matrix.solve(&mut y);
        let back = (0..bodies).flat_map(|k| y[renumbered(k)]);
        let error = difference(back, x.into_iter().flatten());
        assert!(error < 1e-12, "{bodies}: {error:e}");
    }
}

fn bits(x: &[[f64; SIZE]]) -> Vec<u64> {
    x.iter().flatten().map(|x| x.to_bits()).collect()
}

#[test]
fn bits_depend_on_the_matrix_alone() {
    let mut chance = Chance(3);
    let graphs: Vec<_> = [(60, 150), (40, 30)]
        .map(|(bodies, count)| (bodies, chance.pairs(bodies, count)))
        .into_iter()
        .collect();
    let mut used = Matrix::default();
    let mut widths = Vec::new();
    for (bodies, pairs) in [&graphs[0], &graphs[1], &graphs[0], &graphs[0]] {
        let system = System::new(&mut chance, *bodies, pairs);
        let b = sides(&mut chance, *bodies);
        used.fit(*bodies, pairs);
        system.fill(&mut used);
        used.factor().unwrap();
        let mut x = b.clone();
        used.solve(&mut x);
        for numbers in [1, 4, 8] {
            let mut fresh = system.matrix();
            fresh.width = Width::detect().at_most(numbers);
            widths.push(fresh.width);
            fresh.factor().unwrap();
            let mut y = b.clone();
            fresh.solve(&mut y);
            assert_eq!(bits(&x), bits(&y), "{:?}", fresh.width);
        }
    }
    assert!(widths.contains(&Width::PLAIN));
}

#[test]
fn says_where_it_is_not_positive() {
    let mut chance = Chance(4);
    for (body, unknown) in [(0, 0), (3, 2), (11, 5)] {
        let mut system = System::new(&mut chance, 12, &[]);
        system.diagonal[body][unknown][unknown] = -0.1;
        assert_eq!(system.matrix().factor(), Err(NotPositive { body, unknown }));
        system.diagonal[body][unknown][unknown] = f64::NAN;
        assert_eq!(system.matrix().factor(), Err(NotPositive { body, unknown }));
    }
    // A coupling that is larger than both bodies: the one that is eliminated second has no positive pivot.
    let mut system = System::new(&mut chance, 9, &[]);
    let mut block = Block::default();
    block[1][4] = 0.2;
    system.pairs.push(([5, 2], block));
    let error = system.matrix().factor().unwrap_err();
    assert!([(5, 1), (2, 4)].contains(&(error.body, error.unknown)), "{error}");
    // After that the same matrix can be used again.
    let mut matrix = system.matrix();
    assert!(matrix.factor().is_err());
    matrix.clear();
    system.pairs[0].1[1][4] = 0.05;
    system.fill(&mut matrix);
    matrix.factor().unwrap();
    let b = sides(&mut chance, 9);
    let mut x = b.clone();
    matrix.solve(&mut x);
    let exact = dense_solution(system.dense(), &b).unwrap();
    assert!(difference(x.into_iter().flatten(), exact.into_iter()) < 1e-14);
}

#[test]
fn nothing_and_bodies_alone() {
    let mut matrix = Matrix::default();
    matrix.factor().unwrap();
    matrix.fit(0, &[]);
    matrix.factor().unwrap();
    matrix.solve(&mut []);
    assert_eq!(matrix.filled(), 0);
    matrix.fit(3, &[[2, 0]]);
    for body in 0..3 {
        let mut block = Block::default();
        for k in 0..SIZE {
            block[k][k] = 2.0 + body as f64;
        }
        matrix.add_diagonal(body, &block);
    }
    matrix.factor().unwrap();
    let mut x = [[6.0; SIZE]; 3];
    matrix.solve(&mut x);
    assert!((x[1][3] - 2.0).abs() < 1e-15);
    assert_eq!(matrix.filled(), 4);
}

/// Running bond: courses are shifted by half a brick, so that a brick touches two beside it, two above and two below.
fn wall(columns: u32, courses: u32) -> (usize, Vec<[u32; 2]>) {
    let mut pairs = Vec::new();
    for course in 0..courses {
        for column in 0..columns {
            let k = course * columns + column;
            if column + 1 < columns {
                pairs.push([k, k + 1]);
            }
            if course + 1 < courses {
                let above = k + columns;
                pairs.push([k, above]);
                match course % 2 {
                    0 if column > 0 => pairs.push([k, above - 1]),
                    1 if column + 1 < columns => pairs.push([k, above + 1]),
                    _ => {}
                }
            }
        }
    }
    ((columns * courses) as usize, pairs)
}

/// Bodies scattered in a cube, coupled to the nearest ones.
fn heap(chance: &mut Chance, bodies: usize, count: usize) -> (usize, Vec<[u32; 2]>) {
    let points: Vec<[f64; 3]> =
        (0..bodies).map(|_| std::array::from_fn(|_| chance.next())).collect();
    let mut near = Vec::new();
    for i in 0..bodies {
        for j in 0..i {
            let square: f64 = (0..3).map(|k| (points[i][k] - points[j][k]).powi(2)).sum();
            if square < (40.0 / bodies as f64).powf(2.0 / 3.0) {
                near.push((square, [j as u32, i as u32]));
            }
        }
    }
    near.sort_by(|a, b| a.0.total_cmp(&b.0));
    near.truncate(count);
    let mut pairs: Vec<_> = near.into_iter().map(|(_, pair)| pair).collect();
    pairs.sort_unstable();
    (bodies, pairs)
}

#[test]
fn fill_of_walls_is_small() {
    for (columns, courses, most) in [(30, 7, 2_000), (10, 21, 2_500), (100, 21, 40_000)] {
        let (bodies, pairs) = wall(columns, courses);
        let mut matrix = Matrix::default();
        matrix.fit(bodies, &pairs);
        assert!(matrix.filled() < most, "{columns} x {courses}: {}", matrix.filled());
    }
}

/// Prints times: `cargo test --release -p riprap-core --lib sparse -- --ignored --nocapture`.
#[test]
#[ignore = "measures times"]
fn times() {
    let mut chance = Chance(5);
    let cases = [
        ("wall 30 x 7", wall(30, 7)),
        ("wall 10 x 21", wall(10, 21)),
        ("wall 100 x 21", wall(100, 21)),
        ("wall 200 x 50", wall(200, 50)),
        ("heap 500, 800", heap(&mut chance, 500, 800)),
        ("heap 500, 1500", heap(&mut chance, 500, 1500)),
        ("heap 500, 2500", heap(&mut chance, 500, 2500)),
        ("heap 2000, 8000", heap(&mut chance, 2000, 8000)),
        ("heap 5000, 20000", heap(&mut chance, 5000, 20000)),
    ];
    for (name, (bodies, pairs)) in cases {
        let system = System::new(&mut chance, bodies, &pairs);
        let best = |repeats: usize, work: &mut dyn FnMut()| {
            let time = |_| {
                let start = std::time::Instant::now();
                work();
                start.elapsed().as_secs_f64()
            };
            1e3 * (0..repeats).map(time).fold(f64::INFINITY, f64::min)
        };
        let mut matrix = Matrix::default();
        let analysis = best(5, &mut || {
            matrix.fit(0, &[]);
            matrix.fit(bodies, &pairs);
        });
        let assembly = best(5, &mut || {
            matrix.clear();
            system.fill(&mut matrix);
        });
        let b = sides(&mut chance, bodies);
        let mut x = b.clone();
        let widths = [1, 4, 8].map(|numbers| {
            matrix.width = Width::detect().at_most(numbers);
            let factor = best(if bodies < 1000 { 50 } else { 5 }, &mut || matrix.factor().unwrap());
            let solve = best(10, &mut || {
                x.clone_from(&b);
                matrix.solve(&mut x);
            });
            format!("{factor:.3} {solve:.3}")
        });
        println!(
            "{name}: {} pairs, {} blocks, {} fronts; analysis {analysis:.3}, assembly {assembly:.3}, factor and solve {} ms; {} bytes a pair",
            pairs.len(),
            matrix.filled(),
            matrix.fronts.list.len(),
            widths.join(", "),
            matrix.bytes() / pairs.len()
        );
    }
}
