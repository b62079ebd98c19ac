//! Round trips, every truncation and flip, forged lengths, random bytes.

use super::pack::put;
use super::*;
use flate2::Compression;
use flate2::write::ZlibEncoder;
use proptest::prelude::*;
use riprap_testkit::Counting;
use std::io::Write;

#[global_allocator]
static ALLOCATOR: Counting = Counting::new();

type State = (u64, Vec<f64>, String);

fn sample() -> State {
    (7, (0..300).map(|i| f64::from(i) * 0.1).collect(), "phase".to_owned())
}

fn decoded(bytes: &[u8]) -> Result<State, CheckpointError> {
    decode(bytes, "test", Path::new("x.rck"))
}

#[test]
fn round_trip() {
    let dir = tempfile::tempdir().unwrap();
    let path = dir.path().join("a.rck");
    write(&path, "test", &sample()).unwrap();
    assert_eq!(read::<State>(&path, "test").unwrap(), sample());
    assert!(matches!(read::<State>(&path, "other"), Err(CheckpointError::Kind { .. })));
    assert!(matches!(read::<Vec<String>>(&path, "test"), Err(CheckpointError::Decode { .. })));
    let missing = read::<State>(&dir.path().join("none.rck"), "test");
    assert!(matches!(missing, Err(CheckpointError::Read { .. })));
    assert!(encode("a kind that is far too long", &1).is_err());
}

#[test]
fn every_truncation_and_every_flipped_byte_is_told() {
    let bytes = encode("test", &sample()).unwrap();
    for n in 0..bytes.len() {
        assert!(matches!(decoded(&bytes[..n]), Err(CheckpointError::Truncated { .. })), "{n}");
        let mut bad = bytes.clone();
        bad[n] ^= 1 << (n % 8);
        assert!(decoded(&bad).is_err(), "flip at {n}");
    }
    let mut long = bytes.clone();
    long.push(0);
    assert!(matches!(decoded(&long), Err(CheckpointError::Trailing { .. })));
    let mut newer = bytes.clone();
    newer[8] = FORMAT_VERSION as u8 + 1;
    assert!(matches!(
        decoded(&newer),
        Err(CheckpointError::Newer { found, .. }) if found == FORMAT_VERSION + 1
    ));
    let mut older = bytes.clone();
    older[8] = 1;
    assert!(matches!(decoded(&older), Err(CheckpointError::Older { found: 1, .. })));
    assert!(matches!(decoded(b"PK\x03\x04 zip"), Err(CheckpointError::Foreign { .. })));
    let mut flipped = bytes;
    *flipped.last_mut().unwrap() ^= 1;
    assert!(matches!(decoded(&flipped), Err(CheckpointError::Checksum { .. })));
}

/// Blocks that are stored end within numbers and at the edges of what is gathered, and any reader of zlib reads them.
#[test]
fn both_packings_hold_the_same() {
    for length in [0, 1, 8_191, 8_192, 8_193, 40_000] {
        let state: State = (1, (0..length).map(f64::from).collect(), "x".repeat(70_000));
        for packing in [Packing::Small, Packing::Quick] {
            let bytes = pack::encode_as("test", &state, packing).unwrap();
            assert_eq!(decoded(&bytes).unwrap(), state, "{packing:?}");
        }
    }
}

/// A disk that is full after so many bytes.
struct Full(u64);

impl Write for Full {
    fn write(&mut self, bytes: &[u8]) -> io::Result<usize> {
        let room = self.0.min(bytes.len() as u64);
        self.0 -= room;
        match room {
            0 => Err(io::ErrorKind::StorageFull.into()),
            room => Ok(room as usize),
        }
    }

    fn flush(&mut self) -> io::Result<()> {
        Ok(())
    }
}

/// The encoder has no words for what the disk says.
#[test]
fn a_full_disk_is_told_as_such() {
    let numbers: Vec<f64> = (0..400_000).map(f64::from).map(f64::sqrt).collect();
    for packing in [Packing::Small, Packing::Quick] {
        for room in [0, 10, 100_000, 2_000_000] {
            let error = put(&mut Full(room), "test", &numbers, packing).unwrap_err();
            let (kind, text) = (error.kind(), error.to_string());
            assert_eq!(kind, io::ErrorKind::StorageFull, "{packing:?} {room}: {text}");
        }
    }
}

/// The same from the thread that writes.
#[cfg(target_os = "linux")]
#[test]
fn a_full_device_is_told_as_such() {
    let full = Path::new("/dev/full");
    if full.exists() {
        let mut file = fs::OpenOptions::new().write(true).open(full).unwrap();
        let numbers = vec![0.1; 1_000_000];
        let written = behind::behind(&mut file, |file| put(file, "test", &numbers, Packing::Quick));
        assert_eq!(written.unwrap_err().kind(), io::ErrorKind::StorageFull);
    }
}

/// Whoever runs a model that fills the memory can still stop it.
#[test]
fn writing_takes_no_second_copy_of_the_state() {
    let dir = tempfile::tempdir().unwrap();
    // 16 MB that can hardly be compressed.
    let numbers: Vec<f64> = (0..2_000_000).map(f64::from).map(f64::sqrt).collect();
    for packing in [Packing::Small, Packing::Quick] {
        let path = dir.path().join("a.rck");
        let (most, written) =
            ALLOCATOR.most_during(|| pack::write_as(&path, "test", &numbers, packing));
        written.unwrap();
        assert!(most < 8 << 20, "{packing:?}: {most} bytes");
    }
}

#[test]
fn forged_lengths_do_not_allocate() {
    // A forger can make the checksum fit, so the ratio is what stands between the head and memory.
    let forge = |claimed: u64| {
        let mut bytes = encode("test", &sample()).unwrap();
        bytes[SUM_AT - 16..SUM_AT - 8].copy_from_slice(&claimed.to_le_bytes());
        let sum = checksum(&bytes[..SUM_AT], &bytes[HEAD..]);
        bytes[SUM_AT..HEAD].copy_from_slice(&sum);
        bytes
    };
    assert!(matches!(decoded(&forge(u64::MAX)), Err(CheckpointError::Absurd { .. })));
    assert!(matches!(decoded(&forge(10_000)), Err(CheckpointError::Decode { .. })));
    assert!(matches!(decoded(&forge(10)), Err(CheckpointError::Decode { .. })));
}

#[test]
fn a_vector_length_inside_the_payload_does_not_allocate() {
    // Valid container whose payload claims a vector of 2^60 numbers.
    let bytes = encode("test", &(7u64, 1u64 << 60)).unwrap();
    assert!(matches!(decoded(&bytes), Err(CheckpointError::Decode { .. })));
}

#[test]
fn two_are_kept_and_a_broken_one_is_skipped() {
    let dir = tempfile::tempdir().unwrap();
    fs::create_dir(dir.path().join("checkpoints")).unwrap();
    let none = latest::<State>(dir.path(), "test").unwrap_err();
    assert!(none.to_string().contains("no usable checkpoint"));
    for step in [10, 20, 30] {
        write_and_prune(
            dir.path(),
            "test",
            step,
            &(step, Vec::<f64>::new(), String::new()),
            if step == 20 { Packing::Small } else { Packing::Quick },
        )
        .unwrap();
    }
    let steps: Vec<u64> = all(dir.path()).unwrap().iter().map(|f| f.0).collect();
    assert_eq!(steps, vec![20, 30]);
    assert_eq!(latest::<State>(dir.path(), "test").unwrap().value.0, 30);
    let newest = path_for(dir.path(), 30);
    let bytes = fs::read(&newest).unwrap();
    fs::write(&newest, &bytes[..bytes.len() / 2]).unwrap();
    let fallback = latest::<State>(dir.path(), "test").unwrap();
    assert_eq!(fallback.value.0, 20);
    assert!(fallback.broken[0].to_string().contains("truncated"), "{}", fallback.broken[0]);
    fs::write(path_for(dir.path(), 20), b"").unwrap();
    let none = latest::<State>(dir.path(), "test").unwrap_err().to_string();
    assert!(none.contains("000020.rck") && none.contains("000030.rck"), "{none}");
}

proptest! {
    #[test]
    fn random_bytes_never_panic(bytes in proptest::collection::vec(any::<u8>(), 0..400), magic: bool) {
        let mut all = if magic { b"RIPRAPCK\x02\0\0\0".to_vec() } else { Vec::new() };
        all.extend(bytes);
        prop_assert!(decoded(&all).is_err());
    }

    #[test]
    fn random_payloads_never_panic(payload in proptest::collection::vec(any::<u8>(), 0..200)) {
        // Container sound, value random: only the decoder stands.
        let plain = payload.clone();
        let mut bytes = encode("test", &0u8).unwrap();
        let mut zlib = ZlibEncoder::new(Vec::new(), Compression::fast());
        zlib.write_all(&plain).unwrap();
        let packed = zlib.finish().unwrap();
        bytes.truncate(SUM_AT - 16);
        bytes.extend_from_slice(&(plain.len() as u64).to_le_bytes());
        bytes.extend_from_slice(&(packed.len() as u64).to_le_bytes());
        let sum = checksum(&bytes, &packed);
        bytes.extend_from_slice(&sum);
        bytes.extend_from_slice(&packed);
        let _ = decoded(&bytes);
    }

    #[test]
    fn any_state_round_trips(step: u64, data in proptest::collection::vec(any::<u64>().prop_map(f64::from_bits), 0..50), text: String) {
        let bytes = encode("test", &(step, data.clone(), text.clone())).unwrap();
        let back = decoded(&bytes).unwrap();
        prop_assert_eq!(back.0, step);
        prop_assert_eq!(back.2, text);
        let bits = |v: &[f64]| v.iter().map(|x| x.to_bits()).collect::<Vec<_>>();
        prop_assert_eq!(bits(&back.1), bits(&data));
    }
}
