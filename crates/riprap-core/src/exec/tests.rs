use super::*;

#[test]
fn results_come_in_the_order_of_the_items() {
    for threads in [1, 3, 50] {
        let items: Vec<u64> = (0..40).collect();
        let mut seen = Vec::new();
        let work = |n: &u64| {
            std::thread::sleep(std::time::Duration::from_micros(*n % 7 * 300));
            n * n
        };
        side_by_side(threads, &items, work, |r| seen.push(r));
        assert_eq!(seen, items.iter().map(|n| n * n).collect::<Vec<_>>());
    }
    side_by_side(2, &[], |n: &u64| *n, |_| panic!("there is nothing to do"));
}

#[test]
fn sums_and_extremes_do_not_depend_on_threads() {
    let value = |k: usize| 1.0 / (1.0 + k as f64);
    let run = |threads, n| {
        let exec = Exec::new(threads).unwrap();
        let [a, b] = exec.sums(n, |k| [value(k), value(k) * value(k)]);
        let largest = exec.largest(n, |k| (k % 3 == 1).then(|| (f64::from(k as u32 % 700), k)));
        (a.to_bits(), b.to_bits(), largest)
    };
    for n in [0, 1, CHUNK, CHUNK + 1, 5000] {
        assert_eq!(run(1, n), run(4, n), "{n}");
        let one: f64 = (0..n).map(value).sum();
        assert!((f64::from_bits(run(1, n).0) - one).abs() < 1e-12);
    }
    // The last of equals, as `max_by` over all of them.
    assert_eq!(run(2, 5000).2, Some((699.0, 3499)));
    let exec = Exec::new(2).unwrap();
    let nan = exec.largest(2000, |k| Some((if k == 700 { f64::NAN } else { 1.0 }, k)));
    assert_eq!(nan.map(|(_, k)| k), Some(700));
}

#[test]
fn chunk_sums_do_not_depend_on_threads() {
    let run = |threads| {
        let exec = Exec::new(threads).unwrap();
        let mut a: Vec<f64> = (0..5000).map(|k| 1.0 / (1.0 + f64::from(k))).collect();
        let mut b = a.clone();
        let mut sums = vec![0.0; a.len().div_ceil(CHUNK)];
        exec.chunks2(&mut a, &mut b, &mut sums, |_, a, b, sum| {
            for (x, y) in a.iter_mut().zip(b) {
                *x *= 3.0;
                *sum += *x * *y;
            }
        });
        sums.iter().sum::<f64>().to_bits()
    };
    assert_eq!(run(1), run(2));
    assert_eq!(run(1), run(5));
}
