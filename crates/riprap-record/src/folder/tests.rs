//! Continued runs leave the same bytes; other folders are left alone.

use super::super::manifest::Ended;
use super::super::table::Table;
use super::super::vtu::PvdEntry;
use super::*;
use riprap_testkit::sample;
use std::collections::BTreeMap;

/// All files with their bytes, except the manifest.
fn snapshot(path: &Path) -> BTreeMap<PathBuf, Vec<u8>> {
    let mut out = BTreeMap::new();
    for folder in [path.to_owned(), path.join("frames"), path.join("checkpoints")] {
        for entry in fs::read_dir(&folder).unwrap() {
            let file = entry.unwrap().path();
            if file.is_file() && !file.ends_with("manifest.json") {
                out.insert(file.strip_prefix(path).unwrap().to_owned(), fs::read(&file).unwrap());
            }
        }
    }
    out
}

fn steps(run: &mut RunFolder, range: std::ops::Range<u64>) {
    run.begin_histories(&[("slip", "m"), ("unbalanced", "-")]).unwrap();
    run.begin_energy(&[("kinetic", "J/m")]).unwrap();
    for step in range {
        let time = step as f64 * 1e-3;
        run.history_row(step, time, &[Some(time.sin()), (step % 2 == 0).then_some(1e-7)]).unwrap();
        run.energy_row(step, time, &[time * 3.0]).unwrap();
        if step % 3 == 0 {
            run.event(&serde_json::json!({"step": step, "event": "contact broken"})).unwrap();
            run.frame(&Frame { step, time, ..sample() }, &Exec::serial()).unwrap();
        }
        if step % 4 == 0 {
            run.checkpoint("test", step, &(step, run.marks(step))).unwrap();
        }
    }
}

#[test]
fn a_continued_run_leaves_the_same_bytes() {
    let dir = tempfile::tempdir().unwrap();
    let (a, b) = (dir.path().join("a.run"), dir.path().join("b.run"));
    for path in [&a, &b] {
        let mut run = RunFolder::create(path, Existing::Refuse, &Manifest::default()).unwrap();
        run.write_scenario("riprap = 1\n").unwrap();
        steps(&mut run, 0..20);
    }
    assert_eq!(snapshot(&a), snapshot(&b));
    // b: the newest checkpoint is broken, the process died inside a line and between frame and list.
    fs::write(checkpoint::path_for(&b, 16), b"RIPRAPCK").unwrap();
    let mut csv = fs::OpenOptions::new().append(true).open(b.join("histories.csv")).unwrap();
    io::Write::write_all(&mut csv, b"20,0.0").unwrap();
    fs::write(b.join("frames/frame_000099.vtu"), b"half").unwrap();
    assert!(Table::read(&b.join("histories.csv")).unwrap().cut);

    let found = checkpoint::latest::<(u64, Marks)>(&b, "test").unwrap();
    assert_eq!((found.value.0, found.broken.len()), (12, 1));
    let mut run = RunFolder::reopen(&b, &found.value.1).unwrap();
    assert_eq!(run.frames().len(), 5);
    steps(&mut run, 13..20);
    assert_eq!(snapshot(&a), snapshot(&b));
}

#[test]
fn continuing_from_before_the_first_row() {
    let dir = tempfile::tempdir().unwrap();
    let path = dir.path().join("a.run");
    let mut run = RunFolder::create(&path, Existing::Refuse, &Manifest::default()).unwrap();
    let marks = run.marks(0);
    steps(&mut run, 0..5);
    let full = snapshot(&path);
    drop(run);
    let mut run = RunFolder::reopen(&path, &marks).unwrap();
    assert!(!path.join("histories.csv").exists());
    steps(&mut run, 0..5);
    assert_eq!(snapshot(&path), full);
}

#[test]
fn changed_folders_are_not_continued() {
    let dir = tempfile::tempdir().unwrap();
    let path = dir.path().join("a.run");
    let mut run = RunFolder::create(&path, Existing::Refuse, &Manifest::default()).unwrap();
    steps(&mut run, 0..8);
    let marks = run.marks(7);
    drop(run);
    let frame = path.join(block_file(2));
    let bytes = fs::read(&frame).unwrap();
    fs::remove_file(&frame).unwrap();
    assert!(matches!(RunFolder::reopen(&path, &marks), Err(FolderError::FrameMissing { .. })));
    fs::write(&frame, bytes).unwrap();
    // A refused one stays as it is: with rows after the checkpoint, and a file that was not begun at it.
    fs::write(path.join("energy.csv"), "step,time [s]\n").unwrap();
    let mut csv = fs::OpenOptions::new().append(true).open(path.join("histories.csv")).unwrap();
    io::Write::write_all(&mut csv, b"8,0.008,0.1,\n").unwrap();
    let before = snapshot(&path);
    let not_begun = Marks { histories: 0, ..marks.clone() };
    for marks in [&marks, &not_begun] {
        let error = RunFolder::reopen(&path, marks).unwrap_err().to_string();
        assert!(error.contains("energy.csv") && error.contains("truncated or replaced"), "{error}");
        assert!(snapshot(&path) == before, "something was cut");
    }
    assert!(RunFolder::reopen(&dir.path().join("none"), &marks).is_err());
}

#[test]
fn other_folders_are_left_alone() {
    let dir = tempfile::tempdir().unwrap();
    let path = dir.path().join("thesis");
    let m = Manifest::default();
    fs::create_dir(&path).unwrap();
    let mut run = RunFolder::create(&path, Existing::Refuse, &m).unwrap();
    steps(&mut run, 0..1);
    drop(run);
    let again = RunFolder::create(&path, Existing::Refuse, &m);
    assert!(matches!(again, Err(FolderError::Run { .. })));

    let other = dir.path().join("other");
    fs::create_dir(&other).unwrap();
    fs::write(other.join("chapter.tex"), "x").unwrap();
    for existing in [Existing::Refuse, Existing::ReplaceRun] {
        let refused = RunFolder::create(&other, existing, &m);
        assert!(matches!(refused, Err(FolderError::Occupied { .. })));
    }
    let mut run = RunFolder::create(&other, Existing::Force, &m).unwrap();
    steps(&mut run, 0..5);
    drop(run);
    let run = RunFolder::create(&other, Existing::ReplaceRun, &m).unwrap();
    assert!(other.join("chapter.tex").exists() && !other.join(block_file(1)).exists());
    assert_eq!(run.marks(0).frames, vec![]);
    let file = dir.path().join("file");
    fs::write(&file, "").unwrap();
    assert!(matches!(
        RunFolder::create(&file, Existing::Force, &m),
        Err(FolderError::NotAFolder { .. })
    ));
}

#[test]
fn names_that_are_free() {
    let dir = tempfile::tempdir().unwrap();
    let wanted = dir.path().join("slope.run");
    assert_eq!(RunFolder::free_name(&wanted), wanted);
    fs::create_dir(&wanted).unwrap();
    fs::create_dir(dir.path().join("slope-2.run")).unwrap();
    assert_eq!(RunFolder::free_name(&wanted), dir.path().join("slope-3.run"));
}

#[test]
fn what_was_begun_and_not_computed_is_no_hindrance() {
    let dir = tempfile::tempdir().unwrap();
    let running = Manifest { ended: Ended::Running, ..Manifest::default() };
    let begun = |name: &str| {
        let path = dir.path().join(name);
        let mut run = RunFolder::create(&path, Existing::Refuse, &running).unwrap();
        run.write_scenario("riprap = 1\n").unwrap();
        run.begin_histories(&[("slip", "m")]).unwrap();
        run.begin_energy(&[("kinetic", "J/m")]).unwrap();
        let unfinished = path.join("checkpoints/checkpoint_000000000000.rck.tmp");
        fs::write(unfinished, "half").unwrap();
        (path, run)
    };
    let again = |path: &Path| RunFolder::create(path, Existing::Refuse, &running);
    let (path, run) = begun("a.run");
    assert!(again(&path).is_err(), "it is being written");
    assert_ne!(RunFolder::free_name(&path), path);
    drop(run);
    assert_eq!(RunFolder::free_name(&path), path);
    drop(again(&path).unwrap());
    assert!(!path.join("histories.csv").exists());
    let left = fs::read_dir(path.join("checkpoints")).unwrap().count();
    assert_eq!(left, 0);
    // Anything more is somebody's.
    type More = fn(&Path, &mut RunFolder);
    let more: [(&str, More); 7] = [
        ("row", |_, run| run.history_row(0, 0.0, &[None]).unwrap()),
        ("event", |_, run| run.event(&1).unwrap()),
        ("frame", |_, run| {
            run.frame(&sample(), &Exec::serial()).unwrap();
        }),
        ("checkpoint", |_, run| {
            run.checkpoint("test", 0, &0).unwrap();
        }),
        ("end", |_, run| {
            run.write_manifest(&Manifest { ended: Ended::Finished, ..Manifest::default() })
                .unwrap();
        }),
        ("file", |path, _| {
            fs::write(path.join("thesis.txt"), "mine").unwrap();
        }),
        ("picture", |path, _| {
            fs::write(path.join("frames/my.png"), "mine").unwrap();
        }),
    ];
    for (name, add) in more {
        let (path, mut run) = begun(name);
        add(&path, &mut run);
        drop(run);
        let before = snapshot(&path);
        assert!(again(&path).is_err(), "{name}");
        assert_ne!(RunFolder::free_name(&path), path, "{name}");
        assert_eq!(snapshot(&path), before, "{name}");
    }
}

#[test]
fn rows_must_fit_and_numbers_read_back() {
    let dir = tempfile::tempdir().unwrap();
    let path = dir.path().join("a.run");
    let mut run = RunFolder::create(&path, Existing::Refuse, &Manifest::default()).unwrap();
    assert!(run.history_row(0, 0.0, &[]).is_err());
    run.begin_histories(&[("a, \"b\"", "m"), ("c", "-")]).unwrap();
    assert!(run.history_row(0, 0.0, &[None]).is_err());
    let values = [1e-300, -0.1 - 0.2, 1e15, 123_456.789, 5e-5, f64::MIN_POSITIVE, f64::NAN];
    for (i, v) in values.iter().enumerate() {
        run.history_row(i as u64, *v, &[Some(*v), None]).unwrap();
    }
    let table = Table::read(&path.join("histories.csv")).unwrap();
    let back = &table.column("a, \"b\"").unwrap().values;
    assert!(back.iter().zip(values).all(|(a, b)| a.to_bits() == b.to_bits() || b.is_nan()));
    run.write_manifest(&Manifest { ended: Ended::Finished, ..Manifest::default() }).unwrap();
    assert_eq!(Manifest::read(&path).unwrap().ended, Ended::Finished);
}

#[test]
fn each_frame_is_in_both_lists() {
    let dir = tempfile::tempdir().unwrap();
    let path = dir.path().join("a.run");
    let mut run = RunFolder::create(&path, Existing::Refuse, &Manifest::default()).unwrap();
    assert_eq!(vtu::read_pvd(&path.join("run.pvd")).unwrap(), vec![]);
    steps(&mut run, 0..7);
    for list in ["run.pvd", "contacts.pvd"] {
        let entries = vtu::read_pvd(&path.join(list)).unwrap();
        assert_eq!(entries.iter().map(|e| e.time).collect::<Vec<_>>(), vec![0.0, 0.003, 0.006]);
        assert!(entries.iter().all(|e| path.join(&e.file).is_file()));
        // Lists grow by an entry a frame, and are what they would be if written whole.
        let text = std::fs::read_to_string(path.join(list)).unwrap();
        assert_eq!(text, vtu::write_pvd(&entries));
    }
    let frame =
        vtu::read_frame(&path.join(block_file(3)), Some(&path.join(contact_file(3)))).unwrap();
    assert_eq!(frame, Frame { step: 6, time: 0.006, ..sample() });
}

/// A list of bolts, cracks or tetrahedra whose frames all come after the checkpoint stayed, and the continued run named them again.
#[test]
fn a_run_that_goes_on_from_before_a_list_begins_it_again() {
    let dir = tempfile::tempdir().unwrap();
    let path = dir.path().join("a.run");
    let mut run = RunFolder::create(&path, Existing::Refuse, &Manifest::default()).unwrap();
    steps(&mut run, 0..3);
    let marks = run.marks(2);
    steps(&mut run, 3..7);
    drop(run);
    let last = PvdEntry { time: 0.006, file: bolt_file(3) };
    for name in ["bolts.pvd", "cracks.pvd", "tetrahedra.pvd"] {
        fs::write(path.join(name), vtu::write_pvd(std::slice::from_ref(&last))).unwrap();
    }
    fs::write(path.join(bolt_file(1)), "<VTKFile>").unwrap();
    fs::write(path.join(bolt_file(3)), "<VTKFile>").unwrap();
    drop(RunFolder::reopen(&path, &marks).unwrap());
    // Those of frames before it are listed, and no others.
    let left = vtu::read_pvd(&path.join("bolts.pvd")).unwrap();
    assert_eq!(left.iter().map(|e| &e.file).collect::<Vec<_>>(), [&bolt_file(1)]);
    assert!(!path.join("cracks.pvd").exists() && !path.join("tetrahedra.pvd").exists());
}

#[test]
fn two_writers_cannot_share_a_folder() {
    let dir = tempfile::tempdir().unwrap();
    let path = dir.path().join("a.run");
    let manifest = Manifest::default();
    let mut first = RunFolder::create(&path, Existing::Refuse, &manifest).unwrap();
    steps(&mut first, 0..5);
    for existing in [Existing::ReplaceRun, Existing::Force] {
        let second = RunFolder::create(&path, existing, &manifest).unwrap_err();
        assert!(matches!(second, FolderError::InUse { .. }), "{second}");
    }
    let again = RunFolder::reopen(&path, &first.marks(4)).unwrap_err();
    assert!(matches!(again, FolderError::InUse { .. }), "{again}");
    let marks = first.marks(4);
    drop(first);
    RunFolder::reopen(&path, &marks).unwrap();
}
