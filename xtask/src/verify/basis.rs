//! What the rows of the verification table rest on: the scenes as they stand there, and how many entries under *Numerics* in `CHANGELOG.md`
//! concern each. An entry that begins with one of [`SCOPES`] concerns those scenes only, any other all.

use std::path::Path;

use super::table::scenes;

/// Whether an entry concerns the scene with this text.
type Concerns = fn(&str) -> bool;

/// How a *Numerics* entry begins that does not concern all scenes, and the scenes that it concerns.
const SCOPES: [(&str, Concerns); 11] = [
    ("In the plane:", |scene| !in_space(scene)),
    // Blocks with some freedoms prescribed and others not.
    ("Partly held blocks in the plane:", |scene| {
        let moved = scene.contains("motion.velocity.") && !scene.contains("motion.velocity.y");
        !in_space(scene) && (moved || scene.contains("fixed = { "))
    }),
    // Blocks between joints in the plane, of which slivers are merged.
    ("Slivers in the plane:", |scene| {
        !in_space(scene) && scene.contains("smallest_edge") && !scene.contains("voronoi")
    }),
    ("In space:", in_space),
    ("Found contact in space:", |scene| {
        in_space(scene) && !scene.contains("found_contacts = false")
    }),
    // Joints of rigid blocks that can give way to found contact.
    ("Rigid joints in space:", joined),
    // The same where blocks lie on each other at the start: stones that are poured have no joints.
    ("Joints in space that give way:", |scene| joined(scene) && !scene.contains("pour = ")),
    ("Terrain in space:", |scene| in_space(scene) && scene.contains("terrain")),
    ("Rupture of bolts:", |scene| scene.contains("rupture = ")),
    ("Seepage:", |scene| scene.contains("seepage")),
    ("Water:", |scene| scene.contains("[water.")),
];

fn joined(scene: &str) -> bool {
    in_space(scene) && !scene.contains("found_contacts = false") && !scene.contains("deformable")
}

fn in_space(scene: &str) -> bool {
    scene.contains("[space.spatial]")
}

/// What rows rest on today.
#[derive(Debug)]
pub struct Now {
    pub(super) scenes: Vec<Scene>,
}

/// A scene as it stands there.
#[derive(Clone, Debug)]
pub(super) struct Scene {
    pub(super) name: String,
    pub(super) title: String,
    pub(super) digest: String,
    /// Number of *Numerics* entries that concern it.
    pub(super) numerics: usize,
}

impl Now {
    /// Of the repository as it lies there.
    pub fn of(root: &Path) -> Self {
        let changes = std::fs::read_to_string(root.join("CHANGELOG.md")).unwrap_or_default();
        let (fast, long) = scenes(root);
        let scene = |name: String| {
            let text = std::fs::read_to_string(root.join(&name)).unwrap_or_default();
            Scene {
                title: title(&text),
                digest: digest(root, &name),
                numerics: numerics(&changes, &text),
                name,
            }
        };
        Self { scenes: fast.into_iter().chain(long).map(scene).collect() }
    }

    pub(super) fn digest(&self, scene: &str) -> &str {
        self.place(scene).map_or("", |k| &self.scenes[k].digest)
    }

    pub(super) fn numerics(&self, scene: &str) -> usize {
        self.place(scene).map_or(0, |k| self.scenes[k].numerics)
    }

    pub(super) fn place(&self, scene: &str) -> Option<usize> {
        self.scenes.iter().position(|one| one.name == scene)
    }

    pub fn known(&self, scene: &str) -> bool {
        self.place(scene).is_some()
    }
}

/// Number of entries under all headings *Numerics* of a changelog that concern a scene, by its text.
fn numerics(changes: &str, scene: &str) -> usize {
    let concerns = |entry: &str| {
        let scope = SCOPES.iter().find(|(words, _)| entry.starts_with(words));
        scope.is_none_or(|(_, of)| of(scene))
    };
    let mut inside = false;
    let mut count = 0;
    for line in changes.lines() {
        if line.starts_with('#') {
            inside = line.trim_start_matches('#').trim() == "Numerics";
        } else if inside && line.strip_prefix("- ").is_some_and(concerns) {
            count += 1;
        }
    }
    count
}

/// The title of a scene.
fn title(text: &str) -> String {
    let line = text.lines().find_map(|line| line.strip_prefix("title = "));
    let words = line.map(|line| line.trim().trim_matches('"').replace("\\\"", "\""));
    words.unwrap_or_default()
}

/// Digest of a scene and of the files whose names stand in it between quotes (FNV-1a, 64 bits).
fn digest(root: &Path, scene: &str) -> String {
    let path = root.join(scene);
    let text = std::fs::read_to_string(&path).unwrap_or_default();
    let mut hash = 0xcbf2_9ce4_8422_2325_u64;
    let mut add = |bytes: &[u8]| {
        for byte in bytes {
            hash = (hash ^ u64::from(*byte)).wrapping_mul(0x100_0000_01b3);
        }
    };
    // Remarks and empty lines say nothing to the program.
    let said = text.lines().map(str::trim);
    for line in said.filter(|l| !l.is_empty() && !l.starts_with('#')) {
        add(line.as_bytes());
        add(b"\n");
    }
    let folder = path.parent().unwrap_or(root);
    for name in text.split('"').skip(1).step_by(2) {
        let file = folder.join(name);
        if name.contains('.') && file.is_file() {
            add(&std::fs::read(file).unwrap_or_default());
        }
    }
    format!("{hash:016x}")
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn an_entry_can_concern_some_scenes_only() {
        let text = "### Numerics\n- In the plane: a\n- In space: b\n- Found contact in space: c\n- Rigid joints in space: c\n- Joints in space that give way: c\n- Terrain in space: c\n- Seepage: d\n- Water: d\n- Partly held blocks in the plane: d\n- Slivers in the plane: d\n- e\n";
        let space = "[space.spatial]\n";
        assert_eq!(numerics(text, "[space.planar]"), 2);
        assert_eq!(numerics(text, "[space.planar]\nwater.seepage = {}"), 3);
        assert_eq!(numerics(text, "[space.planar]\n[water.seepage]"), 4);
        let held = "[space.planar]\nfixed = { y = false }\n";
        assert_eq!(numerics(text, held), 3);
        assert_eq!(numerics(text, "[space.planar]\nfixed = {}\n"), 2);
        let cut = "[space.planar]\nsmallest_edge = 1\n";
        assert_eq!(numerics(text, cut), 3);
        assert_eq!(numerics(text, &format!("{cut}voronoi = {{}}")), 2);
        let moved = "[space.planar]\nmotion.velocity.x.constant = 0\n";
        assert_eq!(numerics(text, moved), 3);
        assert_eq!(numerics(text, &format!("{moved}motion.velocity.y.constant = 0\n")), 2);
        assert_eq!(numerics(text, space), 5);
        assert_eq!(numerics(text, &format!("{space}pour = {{}}")), 4);
        assert_eq!(numerics(text, &format!("{space}terrain.csv")), 6);
        assert_eq!(numerics(text, &format!("{space}mechanics.deformable")), 3);
        assert_eq!(numerics(text, &format!("{space}found_contacts = false")), 2);
    }

    #[test]
    fn entries_of_all_releases_count() {
        let text = "## Unreleased\n### Fixed\n- a\n### Numerics\n- b\n  more\n- c\n## 0.1\n### Numerics\n- d\n### Added\n- e\n";
        assert_eq!(numerics(text, ""), 3);
    }
}
