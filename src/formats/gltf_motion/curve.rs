//! Keys of a channel, and values between them.

use crate::gltf::{
    FLOAT, GltfFile,
    document::{Interpolation, Path, Sampler, Shape},
};
use effigy_core::io::file::FormatError;
use glam::{DQuat, DVec3, DVec4};

/// Keys and what stands at them.
pub struct Curve {
    /// Seconds, not falling: of keys at one time the last counts from then on.
    times: Vec<f32>,
    /// Rows of 3, or of 4 for rotations; for splines three a key: tangent in, value, tangent out.
    values: Vec<f32>,
    columns: usize,
    interpolation: Interpolation,
}

/// A time between keys.
struct Moment {
    /// The key at or before it.
    key: usize,
    /// Of the way to the next, from 0 to 1.
    share: f64,
}

/// The rows of an accessor, all finite. `shape`, `count`: what it has to have.
pub fn rows<const N: usize>(
    source: &GltfFile,
    at: u32,
    shape: Shape,
    count: u64,
) -> Result<Vec<[f32; N]>, FormatError> {
    let accessor = source.accessor(at)?;
    let fault = |found: String, expected: String| {
        FormatError::metadata(&format!("accessors[{at}]"), found, expected)
    };
    if accessor.shape != shape || accessor.count != count || count == 0 {
        return Err(fault(
            format!("{} of {:?}", accessor.count, accessor.shape),
            format!("{} of {shape:?}", count.max(1)),
        ));
    }
    if accessor.component_type != FLOAT && !accessor.normalized {
        return Err(fault(
            format!("components of the type {}", accessor.component_type),
            "floats, or normalised integers of 8 or 16 bits".into(),
        ));
    }
    let rows = source.rows(at)?;
    match rows
        .as_flattened()
        .iter()
        .find(|number| !number.is_finite())
    {
        Some(number) => Err(fault(number.to_string(), "finite numbers".into())),
        None => Ok(rows),
    }
}

/// The times of a sampler's keys, seconds. They may begin before 0, and several keys may be at one
/// time: exporters write the frames that an animation has.
pub fn times(source: &GltfFile, sampler: &Sampler) -> Result<Vec<f32>, FormatError> {
    let count = source.accessor(sampler.input)?.count;
    let times = rows::<1>(source, sampler.input, Shape::Scalar, count)?.into_flattened();
    match times.windows(2).find(|pair| pair[0] > pair[1]) {
        Some(pair) => Err(FormatError::metadata(
            &format!("accessors[{}]", sampler.input),
            format!("a key at {} s after one at {} s", pair[1], pair[0]),
            "keys in the order of their times",
        )),
        None => Ok(times),
    }
}

impl Curve {
    /// Reads a channel's keys.
    pub fn read(source: &GltfFile, sampler: &Sampler, path: Path) -> Result<Self, FormatError> {
        let times = times(source, sampler)?;
        let each = match sampler.interpolation {
            Interpolation::CubicSpline => 3,
            _ => 1,
        };
        let (output, count) = (sampler.output, each * times.len() as u64);
        let (columns, values) = match path {
            Path::Rotation => (
                4,
                rows::<4>(source, output, Shape::Vec4, count)?.into_flattened(),
            ),
            _ => (
                3,
                rows::<3>(source, output, Shape::Vec3, count)?.into_flattened(),
            ),
        };
        Ok(Self {
            times,
            values,
            columns,
            interpolation: sampler.interpolation,
        })
    }

    fn row(&self, at: usize) -> DVec4 {
        let row = &self.values[at * self.columns..][..self.columns];
        let w = row.get(3).copied().unwrap_or_default();
        DVec4::new(row[0].into(), row[1].into(), row[2].into(), w.into())
    }

    fn moment(&self, time: f64) -> Moment {
        let after = self.times.partition_point(|&key| f64::from(key) <= time);
        let before = after.saturating_sub(1);
        let [Some(&a), Some(&b)] = [self.times.get(before), self.times.get(before + 1)] else {
            return Moment {
                key: before,
                share: 0.0,
            };
        };
        let share = (time - f64::from(a)) / f64::from(b - a);
        Moment {
            key: before,
            share: share.clamp(0.0, 1.0),
        }
    }

    /// The numbers at a time, before anything is made of them.
    fn sample(&self, time: f64) -> DVec4 {
        let Moment { key, share } = self.moment(time);
        match self.interpolation {
            Interpolation::Step => self.row(key),
            Interpolation::Linear if share == 0.0 => self.row(key),
            Interpolation::Linear => self.row(key).lerp(self.row(key + 1), share),
            Interpolation::CubicSpline if share == 0.0 => self.row(3 * key + 1),
            Interpolation::CubicSpline => {
                let span = f64::from(self.times[key + 1] - self.times[key]);
                let [from, out] = [self.row(3 * key + 1), self.row(3 * key + 2)];
                let [into, to] = [self.row(3 * key + 3), self.row(3 * key + 4)];
                let (s, s2, s3) = (share, share * share, share * share * share);
                (2.0 * s3 - 3.0 * s2 + 1.0) * from
                    + span * (s3 - 2.0 * s2 + s) * out
                    + (3.0 * s2 - 2.0 * s3) * to
                    + span * (s3 - s2) * into
            }
        }
    }

    /// A translation.
    pub fn vector(&self, time: f64) -> DVec3 {
        self.sample(time).truncate()
    }

    /// A rotation; None where the numbers are those of none.
    pub fn rotation(&self, time: f64) -> Option<DQuat> {
        let unit = |row: DVec4| row.try_normalize().map(DQuat::from_vec4);
        let Moment { key, share } = self.moment(time);
        if self.interpolation == Interpolation::Linear && share > 0.0 {
            // The shorter way round.
            return Some(unit(self.row(key))?.slerp(unit(self.row(key + 1))?, share));
        }
        unit(self.sample(time))
    }
}
