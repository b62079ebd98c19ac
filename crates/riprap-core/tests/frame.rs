//! Frames say what is wrong with them.

use riprap_core::field::Part;
use riprap_core::frame::Frame;
use riprap_testkit::{sample, solid_sample};

#[test]
fn faces_of_solids_are_checked() {
    assert_eq!(solid_sample().fault(), None);
    let mut f = solid_sample();
    f.offsets = vec![0, 7, 12];
    assert!(f.fault().unwrap().contains("eight"));
    let mut f = solid_sample();
    f.solids.as_mut().unwrap().corners[3] = 4;
    assert!(f.fault().unwrap().contains("corner"));
    assert_eq!(solid_sample().solids.unwrap().of(0).len(), 6);
}

#[test]
fn faults_are_named() {
    assert_eq!(sample().fault(), None);
    assert_eq!(Frame::default().fault(), None);
    let mut f = sample();
    f.offsets[2] = 6;
    assert!(f.fault().is_some());
    let mut f = sample();
    f.block_columns[1].data.pop();
    assert!(f.fault().unwrap().contains("rotation"));
}

#[test]
fn parts_of_columns() {
    let f = sample();
    assert_eq!(f.block_columns[0].numbers(Part::X), vec![0.1, 0.3]);
    assert_eq!(f.block_columns[0].numbers(Part::Whole), vec![0.1, 0.5]);
    assert_eq!(f.block_columns[1].numbers(Part::Whole), vec![-0.01, 0.02]);
    assert_eq!(f.outline(1).len(), 3);
}
