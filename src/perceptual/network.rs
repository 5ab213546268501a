//! The two networks: what they do, in order, and how wide their layers are.

/// A network of ST-LPIPS.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Network {
    /// After AlexNet: 2.5 million weights.
    Alex,
    /// After VGG16: 14.7 million weights, four times the work.
    Vgg,
}

/// A step of a network.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Step {
    /// A convolution with stride 1 and a bias.
    Convolve(Shape),
    /// The greatest of 0 and a number.
    Rectify,
    /// The greatest number of each window, with stride 1 and no padding. Its side, px.
    Pool(usize),
    /// A blur by [1, 2, 1] / 4 across and down, with stride 2, after two mirrored pixels were added
    /// to each side.
    Blur,
}

/// The shape of a convolution.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Shape {
    /// Its name in files of weights.
    pub name: &'static str,
    /// Channels that it reads and writes.
    pub from: usize,
    pub to: usize,
    /// Its window's side, px.
    pub window: usize,
    /// Zeros that are added to each side, px.
    pub pad: usize,
}

impl Shape {
    /// Weights of one channel that it writes.
    pub fn fan(&self) -> usize {
        self.from * self.window * self.window
    }
}

const fn convolve(name: &'static str, channels: [usize; 2], window: usize, pad: usize) -> Step {
    Step::Convolve(Shape {
        name,
        from: channels[0],
        to: channels[1],
        window,
        pad,
    })
}

/// Layers of a network: after each, features are compared.
pub const LAYERS: usize = 5;
type Layers = [&'static [Step]; LAYERS];

const ALEX: Layers = [
    &[
        convolve("net.slice1.0", [3, 64], 11, 2),
        Step::Blur,
        Step::Rectify,
    ],
    &[
        Step::Pool(3),
        Step::Blur,
        convolve("net.slice2.5", [64, 192], 5, 2),
        Step::Rectify,
    ],
    &[
        Step::Pool(3),
        Step::Blur,
        convolve("net.slice3.9", [192, 384], 3, 1),
        Step::Rectify,
    ],
    &[convolve("net.slice4.11", [384, 256], 3, 1), Step::Rectify],
    &[convolve("net.slice5.13", [256, 256], 3, 1), Step::Rectify],
];

const VGG: Layers = [
    &[
        convolve("net.slice1.0", [3, 64], 3, 1),
        Step::Rectify,
        convolve("net.slice1.2", [64, 64], 3, 1),
        Step::Rectify,
    ],
    &[
        Step::Pool(2),
        Step::Blur,
        convolve("net.slice2.6", [64, 128], 3, 1),
        Step::Rectify,
        convolve("net.slice2.8", [128, 128], 3, 1),
        Step::Rectify,
    ],
    &[
        Step::Pool(2),
        Step::Blur,
        convolve("net.slice3.12", [128, 256], 3, 1),
        Step::Rectify,
        convolve("net.slice3.14", [256, 256], 3, 1),
        Step::Rectify,
        convolve("net.slice3.16", [256, 256], 3, 1),
        Step::Rectify,
    ],
    &[
        Step::Pool(2),
        Step::Blur,
        convolve("net.slice4.20", [256, 512], 3, 1),
        Step::Rectify,
        convolve("net.slice4.22", [512, 512], 3, 1),
        Step::Rectify,
        convolve("net.slice4.24", [512, 512], 3, 1),
        Step::Rectify,
    ],
    &[
        Step::Pool(2),
        Step::Blur,
        convolve("net.slice5.28", [512, 512], 3, 1),
        Step::Rectify,
        convolve("net.slice5.30", [512, 512], 3, 1),
        Step::Rectify,
        convolve("net.slice5.32", [512, 512], 3, 1),
        Step::Rectify,
    ],
];

impl Network {
    /// The network's name, as in the names of files of weights.
    pub const fn name(self) -> &'static str {
        match self {
            Self::Alex => "alex",
            Self::Vgg => "vgg",
        }
    }

    /// The name of the file with its weights.
    pub const fn file_name(self) -> &'static str {
        match self {
            Self::Alex => "alex_shift_tolerant.pth",
            Self::Vgg => "vgg_shift_tolerant.pth",
        }
    }

    pub(crate) const fn layers(self) -> &'static Layers {
        match self {
            Self::Alex => &ALEX,
            Self::Vgg => &VGG,
        }
    }

    /// Its convolutions in order.
    pub(crate) fn convolutions(self) -> impl Iterator<Item = Shape> {
        let steps = self.layers().iter().copied().flatten();
        steps.filter_map(|step| match step {
            Step::Convolve(shape) => Some(*shape),
            _ => None,
        })
    }

    /// Channels of each layer's features.
    pub(crate) const fn widths(self) -> [usize; LAYERS] {
        match self {
            Self::Alex => [64, 192, 384, 256, 256],
            Self::Vgg => [64, 128, 256, 512, 512],
        }
    }

    /// The smallest side of a picture that it takes, px.
    pub const fn smallest_side(self) -> u32 {
        match self {
            Self::Alex => 21,
            Self::Vgg => 18,
        }
    }

    /// Multiplications and additions of its convolutions in one pass over a picture: half of what
    /// value and gradient take where the target's features are known.
    pub fn operations(self, size: [usize; 2]) -> f64 {
        let mut sides = size;
        let mut operations = 0.0;
        for step in self.layers().iter().copied().flatten() {
            sides = sides.map(|side| step.side(side));
            if let Step::Convolve(shape) = step {
                operations += 2.0 * (shape.fan() * shape.to * sides[0] * sides[1]) as f64;
            }
        }
        operations
    }
}

impl Step {
    /// The side of what it writes for one of what it reads, px.
    pub fn side(&self, side: usize) -> usize {
        match self {
            Self::Convolve(shape) => side + 2 * shape.pad + 1 - shape.window,
            Self::Rectify => side,
            Self::Pool(window) => side + 1 - window,
            Self::Blur => side.div_ceil(2) + 1,
        }
    }
}
