//! Round trips, damage of every kind, the golden head.

use super::super::write::blocks_in_pieces;
use super::super::{PvdEntry, blocks, contacts, read_blocks, read_frame, read_pvd, write_pvd};
use super::*;
use crate::exec::Exec;
use crate::frame::Frame;
use proptest::prelude::*;
use riprap_testkit::{sample, solid_sample};

fn parsed(bytes: &[u8]) -> Result<Vtu, ReadError> {
    parse(bytes, Path::new("x.vtu"))
}

#[test]
fn frame_round_trip() {
    let dir = tempfile::tempdir().unwrap();
    let (b, c) = (dir.path().join("b.vtu"), dir.path().join("c.vtu"));
    let mut odd = sample();
    odd.phase = "böse <\"&\"> phase".to_owned();
    odd.block_columns[0].name = "a<b & \"c\"".to_owned();
    odd.time = 1e-300;
    for frame in [sample(), Frame::default(), odd, solid_sample()] {
        std::fs::write(&b, blocks(&frame, &Exec::serial()).unwrap()).unwrap();
        std::fs::write(&c, contacts(&frame, &Exec::serial()).unwrap()).unwrap();
        assert_eq!(read_frame(&b, Some(&c)).unwrap(), frame);
    }
}

/// A brick, a tetrahedron, and as often again.
fn mixed(times: u32) -> Frame {
    let mut one = solid_sample();
    let whole = one.clone();
    let (cells, points) = (whole.blocks() as u32, whole.points.len() as u32);
    for again in 1..times {
        one.offsets.extend(whole.offsets[1..].iter().map(|end| end + again * points));
        one.points.extend(whole.points.iter().map(|[x, y, z]| [x + f64::from(again), *y, *z]));
        let solids = one.solids.as_mut().unwrap();
        let more = whole.solids.as_ref().unwrap();
        let (faces, corners) = (solids.ends.len() as u32 - 1, solids.corners.len() as u32);
        solids.faces.extend(more.faces[1..].iter().map(|end| end + faces));
        solids.ends.extend(more.ends[1..].iter().map(|end| end + corners));
        solids.corners.extend(&more.corners);
        for (column, more) in one.block_columns.iter_mut().zip(&whole.block_columns) {
            column.data.extend(&more.data);
        }
    }
    assert_eq!(one.blocks() as u32, times * cells);
    one
}

#[test]
fn pieces_are_read_as_one() {
    let dir = tempfile::tempdir().unwrap();
    let path = dir.path().join("b.vtu");
    for frame in [sample(), mixed(1), mixed(4)] {
        let frame = Frame { contact_points: Vec::new(), contact_columns: Vec::new(), ..frame };
        for piece in [1, 2, 3, 5, 100] {
            std::fs::write(&path, blocks_in_pieces(&frame, &Exec::serial(), piece).unwrap())
                .unwrap();
            assert_eq!(read_frame(&path, None).unwrap(), frame, "{piece}");
            let wanted = Wanted { geometry: false, column: &|name| name == "level" };
            let some = read_some(&path, wanted).unwrap();
            let level = frame.column("level");
            assert_eq!(some.cell_columns.first(), level, "{piece}");
        }
    }
    // Damaged ones are refused, none panics.
    let bytes = blocks_in_pieces(&mixed(3), &Exec::serial(), 1).unwrap();
    for at in (0..bytes.len()).step_by(7) {
        let mut bytes = bytes.clone();
        bytes[at] ^= 0x15;
        let _ = parsed(&bytes);
    }
    let text = bytes.windows(7).position(|w| w == b"\"level\"").unwrap();
    let mut bytes = bytes.clone();
    bytes[text..text + 7].copy_from_slice(b"\"other\"");
    let error = parsed(&bytes).unwrap_err().to_string();
    assert!(error.contains("do not have the same arrays"), "{error}");
}

#[test]
fn many_zlib_blocks_are_the_same_for_any_number_of_threads() {
    // 550 kB of points, of which hardly anything is alike: several runs of blocks.
    let n = 23_000u32;
    let noise = |i: u32| {
        f64::from_bits(
            0x3ff0_0000_0000_0000 | (u64::from(i).wrapping_mul(0x9E37_79B9_7F4A_7C15) >> 12),
        )
    };
    let frame = Frame {
        offsets: (0..=n).map(|i| 3 * i).collect(),
        points: (0..3 * n).map(|i| [noise(i), noise(i + 7), 0.0]).collect(),
        block_columns: vec![
            Column::scalar("id", "-", (0..n).map(f64::from).collect()),
            Column::vector("flat", "m", (0..n).map(|i| [noise(i), -1.0]).collect::<Vec<_>>()),
        ],
        ..Frame::default()
    };
    let bytes = blocks(&frame, &Exec::serial()).unwrap();
    assert!(bytes == blocks(&frame, &Exec::new(3).unwrap()).unwrap());
    let v = parsed(&bytes).unwrap();
    assert_eq!(v.points, frame.points);
    assert_eq!(v.cell_columns, frame.block_columns);
}

#[test]
fn every_truncation_is_told_and_no_flip_panics() {
    let dir = tempfile::tempdir().unwrap();
    let path = dir.path().join("solid.vtu");
    let bytes = blocks(&solid_sample(), &Exec::serial()).unwrap();
    for n in 0..bytes.len() {
        let mut bad = bytes.clone();
        bad[n] ^= 1 << (n % 8);
        if parsed(&bad).is_ok() {
            std::fs::write(&path, &bad).unwrap();
            let _ = read_frame(&path, None);
        }
    }
    let bytes = blocks(&sample(), &Exec::serial()).unwrap();
    for n in 0..bytes.len() {
        assert!(parsed(&bytes[..n]).is_err(), "{n}");
        for bit in 0..8 {
            let mut bad = bytes.clone();
            bad[n] ^= 1 << bit;
            let _ = parsed(&bad);
        }
    }
}

#[test]
fn messages_name_the_file_and_the_fault() {
    let bytes = blocks(&sample(), &Exec::serial()).unwrap();
    let cut = parsed(&bytes[..bytes.len() - 3]).unwrap_err().to_string();
    assert!(cut.contains("x.vtu is damaged") && cut.contains("truncated"), "{cut}");
    assert!(matches!(parsed(b"solid stl"), Err(ReadError::Foreign { .. })));
    let mut huge = bytes;
    let at = huge.windows(2).position(|w| w == b"\n_").unwrap() + 2;
    huge[at..at + 8].copy_from_slice(&u64::MAX.to_le_bytes());
    assert!(parsed(&huge).is_err());
}

#[test]
fn a_frame_that_does_not_fit_is_refused() {
    let mut f = sample();
    f.block_columns[0].data.pop();
    assert!(blocks(&f, &Exec::serial()).is_err());
}

#[test]
fn pvd_round_trip() {
    let dir = tempfile::tempdir().unwrap();
    let path = dir.path().join("run.pvd");
    let entries = vec![
        PvdEntry { time: 0.0, file: "frames/frame_000000.vtu".to_owned() },
        PvdEntry { time: 0.1, file: "frames/a & b.vtu".to_owned() },
    ];
    let text = write_pvd(&entries);
    std::fs::write(&path, &text).unwrap();
    assert_eq!(read_pvd(&path).unwrap(), entries);
    // A million entries of one frame had it read a million times.
    let twice = write_pvd(&[entries[0].clone(), entries[0].clone()]);
    std::fs::write(&path, twice).unwrap();
    let refused = read_pvd(&path).unwrap_err().to_string();
    assert!(refused.contains("frame_000000.vtu twice"), "{refused}");
    std::fs::write(&path, &text[..text.len() / 2]).unwrap();
    assert!(read_pvd(&path).is_err());
    std::fs::write(&path, "hello").unwrap();
    assert!(read_pvd(&path).is_err());
}

/// Golden file: the bytes of the head are part of the contract with ParaView.
#[test]
fn golden_head() {
    let bytes = blocks(&sample(), &Exec::serial()).unwrap();
    let at = bytes.windows(2).position(|w| w == b"\n_").unwrap();
    let head = str::from_utf8(&bytes[..at]).unwrap();
    let expected = include_str!("../golden_head.xml");
    assert_eq!(head.trim(), expected.trim());
}

proptest! {
    #[test]
    fn random_bytes_never_panic(
        head in "<\\?xml[ -~\n]{0,200}",
        data in proptest::collection::vec(any::<u8>(), 0..200),
        real in 0usize..3,
    ) {
        let good = blocks(&sample(), &Exec::serial()).unwrap();
        let at = good.windows(2).position(|w| w == b"\n_").unwrap() + 2;
        let mut bytes = if real == 0 { head.into_bytes() } else { good[..at].to_vec() };
        bytes.extend(data);
        if real == 2 {
            bytes.extend_from_slice(b"\n</AppendedData>\n</VTKFile>\n");
        }
        prop_assert!(parsed(&bytes).is_err());
    }
}

#[test]
fn only_what_is_wanted_is_unpacked() {
    let dir = tempfile::tempdir().unwrap();
    let path = dir.path().join("b.vtu");
    let whole = solid_sample();
    std::fs::write(&path, blocks(&whole, &Exec::serial()).unwrap()).unwrap();
    let level = Wanted { geometry: false, column: &|name| name == "level" };
    let some = read_some(&path, level).unwrap();
    assert_eq!((some.step, some.points.len()), (7, 0));
    assert_eq!(some.cell_columns, whole.block_columns[1..]);
    let bare = Wanted { geometry: true, column: &|_| false };
    let frame = read_blocks(&path, bare).unwrap();
    assert!(frame.block_columns.is_empty());
    assert_eq!((frame.points, frame.solids), (whole.points, whole.solids));
}

/// The same file with another number of points or cells in its head.
fn claiming(bytes: &[u8], key: &str, count: u64) -> Vec<u8> {
    let at = bytes.windows(key.len()).position(|w| w == key.as_bytes());
    let from = at.unwrap() + key.len() + 2;
    let to = from + bytes[from..].iter().position(|b| *b == b'"').unwrap();
    [&bytes[..from], count.to_string().as_bytes(), &bytes[to..]].concat()
}

#[test]
fn counts_bound_what_is_unpacked() {
    // 3 MB of zeros, packed: it unpacked to what it liked, whatever the counts said.
    let n = 2000u32;
    let frame = Frame {
        offsets: (0..=n).map(|i| 3 * i).collect(),
        points: vec![[0.0; 3]; 3 * n as usize],
        ..Frame::default()
    };
    let bytes = blocks(&frame, &Exec::serial()).unwrap();
    let said = |bytes: &[u8]| parsed(bytes).unwrap_err().to_string();
    let huge = said(&claiming(&bytes, "NumberOfPoints", 400_000_000));
    assert!(huge.contains("which do not fit in a file of"), "{huge}");
    let many = said(&claiming(&bytes, "NumberOfCells", u64::MAX));
    assert!(many.contains("which do not fit in a file of"), "{many}");
    let few = said(&claiming(&bytes, "NumberOfPoints", 5999));
    assert!(few.contains("more than the counts of the file allow"), "{few}");
}
