//! What a network's steps read and write, and how much memory that takes.

use super::convolution::DeviceConvolution;
use super::operation::Operation;
use effigy_perceptual::Network;
use effigy_perceptual::network::NetworkStep;

/// Feature maps of both pictures.
#[derive(Clone, Copy, Debug)]
pub(super) struct PlannedMaps {
    pub channels: usize,
    /// Width and height.
    pub size: [usize; 2],
    /// Whether the way back needs them; otherwise they lie in the memory of derivatives.
    pub stays: bool,
}

impl PlannedMaps {
    /// Numbers of one picture.
    fn words(&self) -> usize {
        self.channels * self.size[0] * self.size[1]
    }
}

/// A step, but for those that rectify, which the one before does.
#[derive(Clone, Copy, Debug)]
pub(super) struct PlannedStep {
    pub step: NetworkStep,
    /// It reads the maps of this index, and writes the next.
    pub read: usize,
    pub rectifies: bool,
    /// Whether what it reads was rectified in the same layer: the way back has to know.
    pub masks: bool,
    /// The layer that it ends.
    pub ends: Option<usize>,
}

/// A network on pictures of a size.
#[derive(Clone, Debug)]
pub(super) struct NetworkPlan {
    network: Network,
    /// The pictures first.
    pub maps: Vec<PlannedMaps>,
    pub steps: Vec<PlannedStep>,
    /// Where each layer's sums begin, and the end of all.
    pub first_sums: Vec<usize>,
}

impl NetworkPlan {
    /// `size`: width and height of pictures, px.
    pub fn new(network: Network, size: [usize; 2]) -> Self {
        let mut maps = vec![PlannedMaps {
            channels: 3,
            size,
            stays: true,
        }];
        let mut steps: Vec<PlannedStep> = Vec::new();
        let mut first_sums = vec![0];
        for (layer, own) in network.layers().iter().enumerate() {
            for (at, step) in own.iter().enumerate() {
                if *step == NetworkStep::Rectify {
                    continue;
                }
                let read = maps.len() - 1;
                let before = maps[read];
                // The greatest number is looked for in both again.
                let pools = matches!(step, NetworkStep::Pool(_));
                maps[read].stays |= pools;
                let rectifies = own.get(at + 1) == Some(&NetworkStep::Rectify);
                steps.push(PlannedStep {
                    step: *step,
                    read,
                    rectifies,
                    masks: at > 0 && own[at - 1] == NetworkStep::Rectify,
                    ends: None,
                });
                maps.push(PlannedMaps {
                    channels: match step {
                        NetworkStep::Convolve(shape) => shape.to,
                        _ => before.channels,
                    },
                    size: before.size.map(|side| step.side(side)),
                    stays: pools || rectifies,
                });
            }
            if let (Some(last), Some(end)) = (steps.last_mut(), maps.last()) {
                last.ends = Some(layer);
                let sums = Operation::distance_sums(end.size[0] * end.size[1]);
                first_sums.push(first_sums[layer] + sums);
            }
        }
        Self {
            network,
            maps,
            steps,
            first_sums,
        }
    }

    /// Which of the two memories of derivatives has those of the maps of an index.
    pub fn slot(index: usize) -> usize {
        index % 2
    }

    /// Numbers of the two memories of derivatives.
    pub fn slots(&self) -> [usize; 2] {
        let mut slots = [0; 2];
        for (index, maps) in self.maps.iter().enumerate() {
            // What does not stay is of both pictures.
            let words = if maps.stays { 1 } else { 2 } * maps.words();
            slots[Self::slot(index)] = slots[Self::slot(index)].max(words);
        }
        slots
    }

    /// Sums of a view.
    pub fn sums(&self) -> usize {
        self.first_sums.last().copied().unwrap_or(0)
    }

    /// Numbers of each buffer.
    fn buffers(&self) -> impl Iterator<Item = usize> {
        let maps = self.maps.iter().filter(|maps| maps.stays);
        let weights = self.steps.iter().map(|step| match &step.step {
            NetworkStep::Convolve(shape) => DeviceConvolution::words(shape),
            _ => 0,
        });
        maps.map(|maps| 2 * maps.words())
            .chain(self.slots())
            .chain(weights)
            .chain(self.network.widths())
            .chain([self.sums()])
    }

    /// Device memory, bytes.
    pub fn bytes(&self) -> u64 {
        4 * self.buffers().sum::<usize>() as u64
    }

    /// The largest buffer, bytes.
    pub fn largest(&self) -> u64 {
        4 * self.buffers().max().unwrap_or(0) as u64
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn maps_stay_and_are_masked_where_the_way_back_needs_it() {
        let of = |network| NetworkPlan::new(network, [64, 50]);
        let stay = |plan: &NetworkPlan| plan.maps.iter().map(|maps| maps.stays).collect::<Vec<_>>();
        // The picture; a convolution, its blur; a maximum, its blur, a convolution, twice; two more.
        let alex = of(Network::Alex);
        let (yes, no) = (true, false);
        assert_eq!(
            stay(&alex),
            [yes, no, yes, yes, no, yes, yes, no, yes, yes, yes]
        );
        assert!(alex.steps.iter().all(|step| !step.masks));
        // A derivative is never written over what stands beside it.
        assert!(stay(&alex).windows(2).all(|pair| pair[0] || pair[1]));
        let vgg = of(Network::LpipsVgg);
        let masked = vgg.steps.iter().filter(|step| step.masks).count();
        assert_eq!(
            masked,
            13 - 5,
            "all convolutions but the first of each layer"
        );
        let ends: Vec<usize> = vgg.steps.iter().filter_map(|step| step.ends).collect();
        assert_eq!(ends, [0, 1, 2, 3, 4]);
        assert_eq!(vgg.sums(), vgg.first_sums[5]);
        assert_eq!(vgg.first_sums[1], (64 * 50usize).div_ceil(16));
    }
}
