//! The networks: what they do, in order, how wide their layers are and where weights are from.

use std::path::Path;

/// A network of ST-LPIPS or LPIPS.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Network {
    /// ST-LPIPS's after AlexNet: 2.5 million weights.
    Alex,
    /// ST-LPIPS's after VGG16: 14.7 million weights, four times the work.
    Vgg,
    /// LPIPS's: AlexNet as it was trained for ImageNet, whose strides leave little work.
    LpipsAlex,
    /// LPIPS's: VGG16 as it was trained for ImageNet.
    LpipsVgg,
}

/// A file with weights of a network.
#[derive(Clone, Copy, Debug)]
pub struct WeightFile {
    /// Its name.
    pub name: &'static str,
    /// Where it is from.
    pub origin: &'static str,
    pub(crate) parts: WeightParts,
    /// The sum of the magnitudes of all numbers that are read; None where it is not known.
    pub(crate) sum: Option<f64>,
}

/// Which weights a file has.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) enum WeightParts {
    All,
    /// What channels count.
    Heads,
    /// Convolutions.
    Trunk,
}

/// A step of a network.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum NetworkStep {
    /// A convolution with a bias.
    Convolve(ConvolutionShape),
    /// The greatest of 0 and a number.
    Rectify,
    /// The greatest number of each window, with stride 1 and no padding. Its side, px.
    Pool(usize),
    /// Every so many rows and columns alone, from the first.
    Thin(usize),
    /// A blur by [1, 2, 1] / 4 across and down, with stride 2, after two mirrored pixels were added
    /// to each side.
    Blur,
}

/// The shape of a convolution.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ConvolutionShape {
    /// Its name in files of weights.
    pub name: &'static str,
    /// Channels that it reads.
    pub from: usize,
    /// Channels that it writes.
    pub to: usize,
    /// Its window's side, px.
    pub window: usize,
    /// Zeros that are added to each side, px.
    pub pad: usize,
    /// From a window to the next, px.
    pub stride: usize,
}

impl ConvolutionShape {
    /// Weights of one channel that it writes.
    pub fn fan(&self) -> usize {
        self.from * self.window * self.window
    }
}

const fn convolve(
    name: &'static str,
    channels: [usize; 2],
    window: usize,
    pad: usize,
) -> NetworkStep {
    NetworkStep::Convolve(ConvolutionShape {
        name,
        from: channels[0],
        to: channels[1],
        window,
        pad,
        stride: 1,
    })
}

/// Layers of a network: after each, features are compared.
pub const LAYERS: usize = 5;
/// The steps of each layer of a network.
pub type Layers = [&'static [NetworkStep]; LAYERS];

const ALEX: Layers = [
    &[
        convolve("net.slice1.0", [3, 64], 11, 2),
        NetworkStep::Blur,
        NetworkStep::Rectify,
    ],
    &[
        NetworkStep::Pool(3),
        NetworkStep::Blur,
        convolve("net.slice2.5", [64, 192], 5, 2),
        NetworkStep::Rectify,
    ],
    &[
        NetworkStep::Pool(3),
        NetworkStep::Blur,
        convolve("net.slice3.9", [192, 384], 3, 1),
        NetworkStep::Rectify,
    ],
    &[
        convolve("net.slice4.11", [384, 256], 3, 1),
        NetworkStep::Rectify,
    ],
    &[
        convolve("net.slice5.13", [256, 256], 3, 1),
        NetworkStep::Rectify,
    ],
];

const VGG: Layers = [
    &[
        convolve("net.slice1.0", [3, 64], 3, 1),
        NetworkStep::Rectify,
        convolve("net.slice1.2", [64, 64], 3, 1),
        NetworkStep::Rectify,
    ],
    &[
        NetworkStep::Pool(2),
        NetworkStep::Blur,
        convolve("net.slice2.6", [64, 128], 3, 1),
        NetworkStep::Rectify,
        convolve("net.slice2.8", [128, 128], 3, 1),
        NetworkStep::Rectify,
    ],
    &[
        NetworkStep::Pool(2),
        NetworkStep::Blur,
        convolve("net.slice3.12", [128, 256], 3, 1),
        NetworkStep::Rectify,
        convolve("net.slice3.14", [256, 256], 3, 1),
        NetworkStep::Rectify,
        convolve("net.slice3.16", [256, 256], 3, 1),
        NetworkStep::Rectify,
    ],
    &[
        NetworkStep::Pool(2),
        NetworkStep::Blur,
        convolve("net.slice4.20", [256, 512], 3, 1),
        NetworkStep::Rectify,
        convolve("net.slice4.22", [512, 512], 3, 1),
        NetworkStep::Rectify,
        convolve("net.slice4.24", [512, 512], 3, 1),
        NetworkStep::Rectify,
    ],
    &[
        NetworkStep::Pool(2),
        NetworkStep::Blur,
        convolve("net.slice5.28", [512, 512], 3, 1),
        NetworkStep::Rectify,
        convolve("net.slice5.30", [512, 512], 3, 1),
        NetworkStep::Rectify,
        convolve("net.slice5.32", [512, 512], 3, 1),
        NetworkStep::Rectify,
    ],
];

const LPIPS_ALEX: Layers = [
    &[
        NetworkStep::Convolve(ConvolutionShape {
            name: "features.0",
            from: 3,
            to: 64,
            window: 11,
            pad: 2,
            stride: 4,
        }),
        NetworkStep::Rectify,
    ],
    &[
        NetworkStep::Pool(3),
        NetworkStep::Thin(2),
        convolve("features.3", [64, 192], 5, 2),
        NetworkStep::Rectify,
    ],
    &[
        NetworkStep::Pool(3),
        NetworkStep::Thin(2),
        convolve("features.6", [192, 384], 3, 1),
        NetworkStep::Rectify,
    ],
    &[
        convolve("features.8", [384, 256], 3, 1),
        NetworkStep::Rectify,
    ],
    &[
        convolve("features.10", [256, 256], 3, 1),
        NetworkStep::Rectify,
    ],
];

const LPIPS_VGG: Layers = [
    &[
        convolve("features.0", [3, 64], 3, 1),
        NetworkStep::Rectify,
        convolve("features.2", [64, 64], 3, 1),
        NetworkStep::Rectify,
    ],
    &[
        NetworkStep::Pool(2),
        NetworkStep::Thin(2),
        convolve("features.5", [64, 128], 3, 1),
        NetworkStep::Rectify,
        convolve("features.7", [128, 128], 3, 1),
        NetworkStep::Rectify,
    ],
    &[
        NetworkStep::Pool(2),
        NetworkStep::Thin(2),
        convolve("features.10", [128, 256], 3, 1),
        NetworkStep::Rectify,
        convolve("features.12", [256, 256], 3, 1),
        NetworkStep::Rectify,
        convolve("features.14", [256, 256], 3, 1),
        NetworkStep::Rectify,
    ],
    &[
        NetworkStep::Pool(2),
        NetworkStep::Thin(2),
        convolve("features.17", [256, 512], 3, 1),
        NetworkStep::Rectify,
        convolve("features.19", [512, 512], 3, 1),
        NetworkStep::Rectify,
        convolve("features.21", [512, 512], 3, 1),
        NetworkStep::Rectify,
    ],
    &[
        NetworkStep::Pool(2),
        NetworkStep::Thin(2),
        convolve("features.24", [512, 512], 3, 1),
        NetworkStep::Rectify,
        convolve("features.26", [512, 512], 3, 1),
        NetworkStep::Rectify,
        convolve("features.28", [512, 512], 3, 1),
        NetworkStep::Rectify,
    ],
];

/// A file of ST-LPIPS.
const fn shift_tolerant(name: &'static str, sum: f64) -> WeightFile {
    WeightFile {
        name,
        origin: "of stlpips-pytorch 0.0.2, which tools/fetch_perceptual.sh gets",
        parts: WeightParts::All,
        sum: Some(sum),
    }
}

/// What channels count in LPIPS 0.1. The heads of version 0.0 have the same names and shapes.
const fn heads(name: &'static str, sum: f64) -> WeightFile {
    WeightFile {
        name,
        origin: "of lpips 0.1.4, which tools/fetch_perceptual.sh gets",
        parts: WeightParts::Heads,
        sum: Some(sum),
    }
}

/// Convolutions of LPIPS. That they are torchvision's is taken on trust.
const fn trunk(name: &'static str, origin: &'static str) -> WeightFile {
    WeightFile {
        name,
        origin,
        parts: WeightParts::Trunk,
        sum: None,
    }
}

const ALEX_FILES: &[WeightFile] = &[shift_tolerant("alex_shift_tolerant.pth", 31_828.961_92)];
const VGG_FILES: &[WeightFile] = &[shift_tolerant("vgg_shift_tolerant.pth", 283_299.600_4)];
const LPIPS_ALEX_FILES: &[WeightFile] = &[
    heads("lpips_alex.pth", 105.275_354_58),
    trunk(
        "alexnet-owt-7be5be79.pth",
        "of torchvision, which is not fetched: put it there yourself, from \
         https://download.pytorch.org/models/alexnet-owt-7be5be79.pth",
    ),
];
const LPIPS_VGG_FILES: &[WeightFile] = &[
    heads("lpips_vgg.pth", 131.855_508_547),
    trunk(
        "vgg16-397923af.pth",
        "of torchvision, which is not fetched: put it there yourself, from \
         https://download.pytorch.org/models/vgg16-397923af.pth",
    ),
];

impl Network {
    /// The network's name in options.
    pub const fn name(self) -> &'static str {
        match self {
            Self::Alex => "alex",
            Self::Vgg => "vgg",
            Self::LpipsAlex => "lpips-alex",
            Self::LpipsVgg => "lpips-vgg",
        }
    }

    /// What its distance is called: numbers of one can't be set beside those of another.
    pub const fn title(self) -> &'static str {
        match self {
            Self::Alex => "ST-LPIPS (alex)",
            Self::Vgg => "ST-LPIPS (vgg)",
            Self::LpipsAlex => "LPIPS (alex)",
            Self::LpipsVgg => "LPIPS (vgg)",
        }
    }

    /// Whether its distance is LPIPS and not ST-LPIPS.
    pub const fn is_lpips(self) -> bool {
        matches!(self, Self::LpipsAlex | Self::LpipsVgg)
    }

    /// The files with its weights.
    pub const fn files(self) -> &'static [WeightFile] {
        match self {
            Self::Alex => ALEX_FILES,
            Self::Vgg => VGG_FILES,
            Self::LpipsAlex => LPIPS_ALEX_FILES,
            Self::LpipsVgg => LPIPS_VGG_FILES,
        }
    }

    /// The first of its files that is not in a folder.
    pub fn missing(self, folder: &Path) -> Option<WeightFile> {
        let mut files = self.files().iter();
        files.find(|file| !folder.join(file.name).exists()).copied()
    }

    /// Its steps, layer by layer.
    pub const fn layers(self) -> &'static Layers {
        match self {
            Self::Alex => &ALEX,
            Self::Vgg => &VGG,
            Self::LpipsAlex => &LPIPS_ALEX,
            Self::LpipsVgg => &LPIPS_VGG,
        }
    }

    /// Its convolutions in order.
    pub(crate) fn convolutions(self) -> impl Iterator<Item = ConvolutionShape> {
        let steps = self.layers().iter().copied().flatten();
        steps.filter_map(|step| match step {
            NetworkStep::Convolve(shape) => Some(*shape),
            _ => None,
        })
    }

    /// Channels of each layer's features.
    pub const fn widths(self) -> [usize; LAYERS] {
        match self {
            Self::Alex | Self::LpipsAlex => [64, 192, 384, 256, 256],
            Self::Vgg | Self::LpipsVgg => [64, 128, 256, 512, 512],
        }
    }

    /// The smallest side of a picture that it takes, px.
    pub const fn smallest_side(self) -> u32 {
        match self {
            Self::Alex => 21,
            Self::Vgg => 18,
            Self::LpipsAlex => 31,
            Self::LpipsVgg => 16,
        }
    }

    /// Multiplications and additions of its convolutions in one pass over a picture: half of what
    /// value and gradient take where the target's features are known.
    pub fn operations(self, size: [usize; 2]) -> f64 {
        let mut sides = size;
        let mut operations = 0.0;
        for step in self.layers().iter().copied().flatten() {
            sides = sides.map(|side| step.side(side));
            if let NetworkStep::Convolve(shape) = step {
                operations += 2.0 * (shape.fan() * shape.to * sides[0] * sides[1]) as f64;
            }
        }
        operations
    }
}

impl NetworkStep {
    /// The side of what it writes for one of what it reads, px.
    pub fn side(&self, side: usize) -> usize {
        match self {
            Self::Convolve(shape) => (side + 2 * shape.pad - shape.window) / shape.stride + 1,
            Self::Rectify => side,
            Self::Pool(window) => side + 1 - window,
            Self::Thin(step) => side.div_ceil(*step),
            Self::Blur => side.div_ceil(2) + 1,
        }
    }
}
