//! The `sh` stage (spherical harmonics): the colour of each Gaussian as the camera sees it, for
//! avatars whose colours depend on that.

use super::{
    device::Gpu,
    error::Result,
    kernel::{Blocks, Bound, Kernel},
    model::Model,
    stacked::Stacked,
};
use crate::wgsl;
use bytemuck::cast_slice;
use effigy_core::{
    avatar::{Avatar, ShCoefficients},
    layout::{
        SH_WORKGROUP,
        sh::{SPLIT, groups, planes},
    },
};
use std::ops::Range;

pub struct SphericalHarmonics {
    kernel: Kernel,
    degree: usize,
    coefficients: Coefficients,
}

/// The coefficients of the avatar and of its levels.
struct Coefficients {
    low: Stacked,
    high: Stacked,
}

impl SphericalHarmonics {
    /// Writes to the colours in `model`, reads the nodes in `pose`. None for an avatar without
    /// harmonics.
    pub fn new(
        gpu: &Gpu,
        avatar: &Avatar,
        levels: &[Avatar],
        model: &Model,
        blocks: &Blocks,
        pose: &wgpu::Buffer,
    ) -> Result<Option<Self>> {
        let Some(harmonics) = &avatar.sh else {
            return Ok(None);
        };
        let degree = harmonics.degree;
        let coefficients = Coefficients::new(gpu, degree, avatar, levels)?;
        let module = match degree {
            0 | 1 => &wgsl::SH_1,
            2 => &wgsl::SH_2,
            _ => &wgsl::SH_3,
        };
        let bound = coefficients.bindings(0, degree, model, blocks, pose);
        let mut new = Self {
            kernel: Kernel::new(gpu, module, &bound),
            degree,
            coefficients,
        };
        new.bind(gpu, model, blocks, pose);
        Ok(Some(new))
    }

    /// Draws this avatar and these levels from now on, whose harmonics have the degree of those
    /// before.
    pub fn replace(
        &mut self,
        gpu: &Gpu,
        avatar: &Avatar,
        levels: &[Avatar],
        model: &Model,
        blocks: &Blocks,
        pose: &wgpu::Buffer,
    ) -> Result<()> {
        self.coefficients = Coefficients::new(gpu, self.degree, avatar, levels)?;
        self.bind(gpu, model, blocks, pose);
        Ok(())
    }

    /// Binds it to the colours of `model`.
    pub fn bind(&mut self, gpu: &Gpu, model: &Model, blocks: &Blocks, pose: &wgpu::Buffer) {
        for set in 0..model.sets() {
            let bound = self
                .coefficients
                .bindings(set, self.degree, model, blocks, pose);
            self.kernel.set(gpu, set, &bound);
        }
    }

    /// Highest degree.
    pub fn degree(&self) -> usize {
        self.degree
    }

    /// Highest degree of an avatar's harmonics; None for one without.
    pub fn degree_of(avatar: &Avatar) -> Option<usize> {
        avatar.sh.as_ref().map(|sh| sh.degree)
    }

    /// Reads the frame's joints, the nodes and the model, writes the model's colours of the Gaussians
    /// that are drawn. `model`: which of the avatar's levels; 0 is the avatar itself.
    pub fn record(&self, pass: &mut wgpu::ComputePass, block: u32, model: usize, gaussians: u32) {
        let groups = [gaussians.div_ceil(SH_WORKGROUP), 1];
        self.kernel.dispatch_turn(pass, model, block, groups);
    }
}

impl Coefficients {
    fn new(gpu: &Gpu, degree: usize, avatar: &Avatar, levels: &[Avatar]) -> Result<Self> {
        let groups = groups(degree);
        let stack = |name, range: Range<usize>| -> Result<Stacked> {
            let pack = |set: &Avatar| {
                // A level has colours of its avatar's kind.
                let packed = |sh: &ShCoefficients| planes(set, sh, range.clone());
                set.sh.as_ref().map(packed).unwrap_or_default()
            };
            let packed: Vec<_> = std::iter::once(avatar).chain(levels).map(pack).collect();
            let sizes: Vec<u64> = packed
                .iter()
                .map(|set| size_of_val(&set[..]) as u64)
                .collect();
            let stack = Stacked::empty(gpu, name, &sizes)?;
            for (set, data) in packed.iter().enumerate() {
                stack.write(gpu, set, cast_slice(data));
            }
            Ok(stack)
        };
        Ok(Self {
            low: stack("low harmonics", 0..groups.min(SPLIT))?,
            high: stack("high harmonics", SPLIT..groups.max(SPLIT))?,
        })
    }

    /// What the kernel is bound to for a set. The first degree has no high coefficients.
    fn bindings<'a>(
        &'a self,
        set: usize,
        degree: usize,
        model: &'a Model,
        blocks: &'a Blocks,
        pose: &'a wgpu::Buffer,
    ) -> Vec<(u32, Bound<'a>)> {
        let mut bound = vec![
            blocks.frame(),
            (1, Bound::Write(model.gaussians.set(set))),
            (2, Bound::Read(self.low.set(set))),
            (4, Bound::Read(pose.into())),
        ];
        if degree > 1 {
            bound.push((3, Bound::Read(self.high.set(set))));
        }
        bound
    }
}
