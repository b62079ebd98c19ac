//! From places of the model to points of the picture.
//!
//! In perspective a place x to the right, y upwards and z ahead of the eye is drawn at (D x/z, D y/z) with the depth D^2/z, D being the
//! distance of the middle of the picture. This takes planes to planes and keeps their sides, so that what comes after is the same as in a
//! parallel projection; in the middle of the picture it keeps lengths, too.

use riprap_geom::Vec3;

use super::wanted::{Eye, FINE};

/// Share of the picture that stays free around the model.
const MARGIN: f64 = 0.04;
/// What is nearer to the eye than this share of the distance of the middle is not drawn.
const NEAR: f64 = 1e-3;

/// Where a model is seen from.
pub(super) struct Camera {
    /// Unit vectors to the right, upwards and to the eye.
    pub(super) axes: [Vec3; 3],
    /// In perspective: the eye, and the distance of the middle of the picture, m.
    lens: Option<(Vec3, f64)>,
}

/// Unit vector to the eye.
pub(super) fn towards(eye: &Eye) -> Vec3 {
    axes(eye)[2]
}

/// Unit vectors to the right, upwards and to the eye.
pub(super) fn axes(eye: &Eye) -> [Vec3; 3] {
    match eye {
        Eye::From { direction: [azimuth, above], .. } => {
            let (sin, cos) = azimuth.to_radians().sin_cos();
            let (up, level) = above.to_radians().sin_cos();
            // From straight above, the azimuth is down in the picture.
            let right = Vec3::new(-cos, sin, 0.0);
            let eye = Vec3::new(level * sin, level * cos, up);
            [right, eye.cross(right), eye]
        }
        Eye::At { place, target, up, .. } => {
            let eye = (Vec3::from(*place) - Vec3::from(*target)).normalize();
            let right = Vec3::from(*up).cross(eye).normalize();
            [right, eye.cross(right), eye]
        }
    }
}

/// Camera and window. `axes`: those of the eye; `[low, high]`: the model along them, m.
pub(super) fn fitted(
    eye: &Eye,
    axes: [Vec3; 3],
    [low, high]: [Vec3; 2],
    size: [u32; 2],
) -> (Camera, Window) {
    let points = size.map(|side| FINE * side as usize);
    let half = points.map(|side| 0.5 * side as f64);
    let slack = 1e-6 * (high - low).length();
    let (middle, reach) = (0.5 * (low + high), 0.5 * (high - low));
    let room = 1.0 - 2.0 * MARGIN;
    let in_perspective = |eye: Vec3, distance: f64, angle: f64| {
        let zoom = half[1] / (distance * (0.5 * angle).to_radians().tan());
        let window = Window { middle: [0.0; 2], zoom, points, slack };
        (Camera { axes, lens: Some((eye, distance)) }, window)
    };
    match eye {
        Eye::From { angle: None, .. } => {
            let room = |k: usize| room * half[k] / reach[k];
            let window =
                Window { middle: [middle.x, middle.y], zoom: room(0).min(room(1)), points, slack };
            (Camera { axes, lens: None }, window)
        }
        Eye::From { angle: Some(angle), .. } => {
            // The nearest face of the box around the model fills the picture.
            let upwards = room * (0.5 * angle).to_radians().tan();
            let across = upwards * half[0] / half[1];
            let distance = reach.z + (reach.x / across).max(reach.y / upwards);
            let target = middle.x * axes[0] + middle.y * axes[1] + middle.z * axes[2];
            in_perspective(target + distance * axes[2], distance, *angle)
        }
        Eye::At { place, target, angle, .. } => {
            let eye = Vec3::from(*place);
            in_perspective(eye, eye.distance(Vec3::from(*target)), *angle)
        }
    }
}

impl Camera {
    /// A direction along the axes of the camera.
    pub(super) fn turned(&self, way: Vec3) -> Vec3 {
        Vec3::from(self.axes.map(|axis| axis.dot(way)))
    }

    /// A direction of the axes of the camera in those of the model.
    pub(super) fn world_way(&self, way: Vec3) -> Vec3 {
        way.x * self.axes[0] + way.y * self.axes[1] + way.z * self.axes[2]
    }

    /// A place along the axes of the camera, as [`Camera::place`] gives it, in the model, m.
    pub(super) fn world(&self, place: Vec3) -> Vec3 {
        self.lens.map_or(Vec3::ZERO, |(eye, _)| eye) + self.world_way(place)
    }

    /// A place of the picture with its depth, along the axes of the camera, m: in perspective from the eye.
    pub(super) fn place(&self, seen: Vec3) -> Vec3 {
        match self.lens {
            None => seen,
            Some((_, distance)) => {
                let share = seen.z / distance;
                Vec3::new(seen.x / share, seen.y / share, -distance / share)
            }
        }
    }

    /// How far beyond the nearest place that is drawn, m.
    fn ahead(&self, place: Vec3) -> f64 {
        match self.lens {
            None => f64::INFINITY,
            Some((eye, distance)) => self.axes[2].dot(eye - place) - NEAR * distance,
        }
    }

    /// To the right, upwards and the depth, and by what to multiply what is linear in the model so that it is in the picture, too.
    fn seen(&self, place: Vec3) -> (Vec3, f64) {
        match self.lens {
            None => (self.turned(place), 1.0),
            Some((eye, distance)) => {
                let way = self.turned(place - eye);
                let share = distance / -way.z;
                (Vec3::new(share * way.x, share * way.y, share * distance), share)
            }
        }
    }

    /// The part of a polygon that lies before the eye.
    fn before(&self, line: &[Vec3]) -> Vec<Vec3> {
        if line.iter().all(|p| self.ahead(*p) >= 0.0) {
            return line.to_vec();
        }
        let next = line.iter().cycle().skip(1);
        let mut out = Vec::new();
        for (a, b) in line.iter().zip(next) {
            let (from, to) = (self.ahead(*a), self.ahead(*b));
            if from >= 0.0 {
                out.push(*a);
            }
            if (from >= 0.0) != (to >= 0.0) {
                out.push(a.lerp(*b, from / (from - to)));
            }
        }
        out
    }

    /// Corners of a polygon in the picture, m at its middle, with `above` there: its sign is kept. What lies behind the eye is left out.
    pub(super) fn polygon(&self, line: &[Vec3], above: &dyn Fn(Vec3) -> f64) -> Vec<(Vec3, f64)> {
        let place = |p: &Vec3| {
            let (seen, share) = self.seen(*p);
            (seen, share * above(*p))
        };
        self.before(line).iter().map(place).collect()
    }
}

/// From metres to points of the drawing.
pub(super) struct Window {
    middle: [f64; 2],
    pub(super) zoom: f64,
    /// Points to the right and downwards.
    pub(super) points: [usize; 2],
    /// What is nearer than this in depth is at one place, m.
    pub(super) slack: f64,
}

impl Window {
    /// From points and depth to metres: the way back of [`Window::at`].
    pub(super) fn back(&self, at: Vec3) -> Vec3 {
        let half = self.points.map(|side| 0.5 * side as f64);
        let [x, y] = self.middle;
        Vec3::new(x + (at.x - half[0]) / self.zoom, y + (half[1] - at.y) / self.zoom, at.z)
    }

    /// Points of the drawing to a metre at a place along the axes of the camera.
    pub(super) fn scale(&self, camera: &Camera, place: Vec3) -> f64 {
        match camera.lens {
            None => self.zoom,
            Some((_, distance)) => self.zoom * distance / -place.z,
        }
    }

    /// Diagonal of the model, m.
    pub(super) fn reach(&self) -> f64 {
        1e6 * self.slack
    }

    /// To the right and downwards, points; towards the eye, m.
    pub(super) fn at(&self, corner: Vec3) -> Vec3 {
        let half = self.points.map(|side| 0.5 * side as f64);
        let [x, y] = self.middle;
        let (right, up) = (self.zoom * (corner.x - x), self.zoom * (corner.y - y));
        Vec3::new(half[0] + right, half[1] - up, corner.z)
    }
}
