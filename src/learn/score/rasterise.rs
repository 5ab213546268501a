//! Which vertex of a mesh is nearest to what a camera sees at each pixel.

use effigy_core::scene::Camera;
use glam::{DVec2, DVec3};

/// For each pixel the vertex that has the largest share of the nearest triangle there; None where
/// there is none. `vertices`: world, metres.
pub fn nearest_vertices(
    vertices: &[DVec3],
    triangles: &[[u32; 3]],
    camera: &Camera,
) -> Vec<Option<u32>> {
    let [width, height] = camera.size.map(|side| side as usize);
    let mut depths = vec![f64::INFINITY; width * height];
    let mut nearest = vec![None; width * height];
    let seen: Vec<DVec3> = vertices
        .iter()
        .map(|&vertex| camera.view.transform_point3(vertex))
        .collect();
    for triangle in triangles {
        let corners = triangle.map(|vertex| seen[vertex as usize]);
        if corners.iter().any(|corner| corner.z <= camera.near) {
            continue;
        }
        let places = corners.map(|corner| camera.project(corner));
        let area = (places[1] - places[0]).perp_dot(places[2] - places[0]);
        if area == 0.0 || !area.is_finite() {
            continue;
        }
        let min = places[0].min(places[1]).min(places[2]);
        let max = places[0].max(places[1]).max(places[2]);
        // Pixels whose middles may be inside.
        let range = |low: f64, high: f64, side: usize| {
            (low - 0.5).ceil().max(0.0) as usize
                ..(high + 0.5).floor().clamp(0.0, side as f64) as usize
        };
        for y in range(min.y, max.y, height) {
            for x in range(min.x, max.x, width) {
                let at = DVec2::new(x as f64, y as f64) + 0.5;
                let share = |k: usize| {
                    let (a, b) = (places[(k + 1) % 3], places[(k + 2) % 3]);
                    (a - at).perp_dot(b - at) / area
                };
                let shares: [f64; 3] = std::array::from_fn(share);
                if shares.iter().any(|&share| share < 0.0) {
                    continue;
                }
                // Along the picture it is one over the depth that is linear.
                let over: f64 = (0..3).map(|k| shares[k] / corners[k].z).sum();
                let depth = 1.0 / over;
                let pixel = y * width + x;
                if depth < depths[pixel] {
                    depths[pixel] = depth;
                    let largest = (0..3).max_by(|&a, &b| shares[a].total_cmp(&shares[b]));
                    nearest[pixel] = largest.map(|k| triangle[k]);
                }
            }
        }
    }
    nearest
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_nearer_triangle_is_seen_and_the_nearest_corner_of_it() {
        let camera = Camera::look_at(DVec3::new(0.0, 0.0, 2.0), DVec3::ZERO, 1.0, [40, 40]);
        let triangle = |z: f64| {
            [
                DVec3::new(-1.0, -1.0, z),
                DVec3::new(1.0, -1.0, z),
                DVec3::new(0.0, 1.5, z),
            ]
        };
        let vertices = [triangle(0.0), triangle(0.5)].concat();
        // The nearer one comes first or last, and turns either way.
        for triangles in [[[0, 1, 2], [3, 4, 5]], [[5, 4, 3], [2, 1, 0]]] {
            let seen = nearest_vertices(&vertices, &triangles, &camera);
            assert_eq!(seen[38 * 40 + 3], Some(3), "left below");
            assert_eq!(seen[38 * 40 + 37], Some(4), "right below");
            assert_eq!(seen[5 * 40 + 20], Some(5), "above");
            assert_eq!(seen[0], None);
        }
        let behind = Camera::look_at(
            DVec3::new(0.0, 0.0, -2.0),
            DVec3::NEG_Z * 4.0,
            1.0,
            [40, 40],
        );
        assert!(
            nearest_vertices(&vertices, &[[0, 1, 2]], &behind)
                .iter()
                .all(Option::is_none)
        );
    }
}
