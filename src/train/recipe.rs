//! Every weight, rate and count of a training, in one TOML file.

use crate::adam::{Adam, Rates};
use crate::data::DataOptions;
use crate::loss::LossWeights;
use crate::refine::RefineRates;
use crate::start::Sizes;
use effigy_core::avatar::Filter;
use serde::{Deserialize, Serialize};
use std::ops::RangeInclusive;

/// A training's recipe. Unknown keys are refused, and so are missing ones.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Recipe {
    /// Decides everything random.
    pub seed: u64,
    /// The low-pass, written into the avatar's file.
    pub filter: Filter,
    /// How much of everything there is.
    pub sizes: Sizes,
    /// How long it takes.
    pub schedule: Schedule,
    /// What is made small.
    pub loss: LossWeights,
    /// A loss that sees pictures as people do.
    pub perceptual: PerceptualOptions,
    /// How far a step goes.
    pub rates: RateOptions,
    /// Which basis rows stay.
    pub prune: PruneOptions,
    /// How pictures become views.
    pub data: DataOptions,
}

/// How long a training takes.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Schedule {
    /// Steps before pruning.
    pub iterations: u64,
    /// Steps after it, without the loss of correctives.
    pub fine_tune: u64,
    /// Views of a step.
    pub batch: usize,
    /// Steps before correctives learn, of those before pruning.
    pub neutral_share: f64,
    /// Steps before poses, cameras and bones learn, of those before pruning.
    pub refine_share: f64,
}

/// A loss that sees pictures as people do.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct PerceptualOptions {
    /// Which.
    pub kind: PerceptualKind,
    /// Its weight.
    pub weight: f64,
    /// Steps from one that has it to the next. Its weight there is as many times as large, which
    /// makes Adam careful: rather a small part often than a large one seldom.
    pub every: u64,
    /// Side of the part of a view that it sees, px.
    pub window: u32,
    /// Steps before the first that has it, of those before pruning.
    pub from_share: f64,
}

/// Which loss that sees pictures as people do.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum PerceptualKind {
    /// ST-LPIPS with AlexNet.
    StLpipsAlex,
    /// ST-LPIPS with VGG.
    StLpipsVgg,
    /// LPIPS with AlexNet.
    LpipsAlex,
    /// LPIPS with VGG.
    LpipsVgg,
    /// 1 − SSIM, which needs no weights.
    Dssim,
    /// None.
    None,
}

/// How far a step goes: Adam's rates at the start of the training.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct RateOptions {
    /// Of quaternions.
    pub rotation: f64,
    /// Of log scales.
    pub log_scale: f64,
    /// Of the opacities' logits.
    pub opacity: f64,
    /// Of colours.
    pub color: f64,
    /// Of the nodes' offsets, metres.
    pub node_offset: f64,
    /// Of the nodes' bases.
    pub node_basis: f64,
    /// Of the networks.
    pub network: f64,
    /// Of basis rows of rotation.
    pub rotation_basis: f64,
    /// Of basis rows of scale.
    pub scale_basis: f64,
    /// Of basis rows of colour.
    pub color_basis: f64,
    /// Of the logarithms of the cameras' gains; 0: all are 1.
    pub exposure: f64,
    /// Of poses, radians and metres; 0: as the capture has them.
    pub pose: f64,
    /// Of where cameras are and look, metres and radians, likewise.
    pub camera: f64,
    /// Of where joints are in their parents, metres, likewise.
    pub bone: f64,
    /// What is left of the nodes' offsets' rate at the end.
    pub node_offset_end: f64,
    /// What is left of the others at the end, but for those of basis rows.
    pub end: f64,
    /// What is left of those of basis rows.
    pub basis_end: f64,
    /// Weight decay of the networks.
    pub weight_decay: f64,
}

impl RateOptions {
    /// The rates when a share of the training is over, 0 to 1: exponential decay.
    pub fn at(&self, progress: f64) -> Rates {
        let left = |end: f64| end.powf(progress.clamp(0.0, 1.0));
        let other = left(self.end);
        let basis = left(self.basis_end);
        Rates {
            rotation: self.rotation * other,
            log_scale: self.log_scale * other,
            opacity: self.opacity * other,
            color: self.color * other,
            node_offset: self.node_offset * left(self.node_offset_end),
            node_basis: self.node_basis * other,
            network: self.network * other,
            bases: [self.rotation_basis, self.scale_basis, self.color_basis].map(|r| r * basis),
        }
    }

    /// Those of poses, cameras and bones.
    pub fn refine_at(&self, progress: f64) -> RefineRates {
        let left = self.end.powf(progress.clamp(0.0, 1.0));
        RefineRates {
            pose: self.pose * left,
            camera: self.camera * left,
            bone: self.bone * left,
        }
    }

    /// Adam's constants.
    pub fn adam(&self) -> Adam {
        Adam {
            weight_decay: self.weight_decay,
            ..Adam::DEFAULT
        }
    }
}

/// Which basis rows stay.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct PruneOptions {
    /// How rows are chosen.
    pub by: PruneBy,
    /// Rows that stay, of the Gaussians, for each attribute.
    pub share: f64,
    /// Pictures that are looked at where they choose.
    pub pictures: usize,
}

/// How rows that stay are chosen.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum PruneBy {
    /// As many of each attribute, those that vary most over the training's poses.
    Variance,
    /// Those whose change over poses changes its pictures most, as many over all attributes.
    Pictures,
}

/// A recipe that comes with the program.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Preset {
    /// The paper's sizes and lengths, its predecessor's rates.
    Paper,
    /// A person in minutes, for small pictures.
    Quick,
}

impl Preset {
    /// Every preset.
    pub const ALL: [Self; 2] = [Self::Paper, Self::Quick];

    /// Its name.
    pub fn name(self) -> &'static str {
        match self {
            Self::Paper => "paper",
            Self::Quick => "quick",
        }
    }

    /// Its file, with what every key means.
    pub fn text(self) -> &'static str {
        match self {
            Self::Paper => include_str!("recipes/paper.toml"),
            Self::Quick => include_str!("recipes/quick.toml"),
        }
    }

    /// The recipe.
    pub fn recipe(self) -> Recipe {
        Recipe::parse(self.text()).expect("a test reads every preset")
    }
}

impl Recipe {
    /// Reads a recipe.
    ///
    /// # Errors
    /// When a key is unknown or missing, or a number is out of range; the text says which.
    pub fn parse(text: &str) -> Result<Self, String> {
        let recipe: Self = toml::from_str(text).map_err(|error| error.to_string())?;
        recipe.check()?;
        Ok(recipe)
    }

    /// The file of a recipe.
    pub fn text(&self) -> String {
        toml::to_string(self).expect("a recipe has nothing that TOML lacks")
    }

    /// Steps of the whole training.
    pub fn steps(&self) -> u64 {
        self.schedule.iterations + self.schedule.fine_tune
    }

    fn check(&self) -> Result<(), String> {
        fn within<T: PartialOrd + std::fmt::Display>(
            what: &str,
            found: T,
            range: RangeInclusive<T>,
        ) -> Result<(), String> {
            if range.contains(&found) {
                return Ok(());
            }
            let [low, high] = [range.start(), range.end()];
            Err(format!("{what} is {found}, expected {low} to {high}"))
        }
        let rate = 0.0..=1.0;
        let share = 0.0..=1.0;
        within("sizes.gaussians", self.sizes.gaussians, 16..=1_000_000)?;
        within("sizes.parts", self.sizes.parts, 1..=1024)?;
        within("sizes.nodes", self.sizes.nodes, 3..=65_536)?;
        within("sizes.hidden", self.sizes.hidden, 1..=128)?;
        within("sizes.head_density", self.sizes.head_density, 0.1..=100.0)?;
        within("sizes.opacity", self.sizes.opacity, 0.01..=0.99)?;
        within("sizes.thickness", self.sizes.thickness, 0.01..=1.0)?;
        within("filter.variance", self.filter.variance, Filter::VARIANCES)?;
        within(
            "schedule.iterations",
            self.schedule.iterations,
            1..=100_000_000,
        )?;
        within(
            "schedule.fine_tune",
            self.schedule.fine_tune,
            0..=100_000_000,
        )?;
        within("schedule.batch", self.schedule.batch, 1..=64)?;
        within(
            "schedule.neutral_share",
            self.schedule.neutral_share,
            share.clone(),
        )?;
        within(
            "schedule.refine_share",
            self.schedule.refine_share,
            share.clone(),
        )?;
        let weights = &self.loss;
        for (what, weight) in [
            ("loss.l1", weights.l1),
            ("loss.scale", weights.scale),
            ("loss.scale_above", weights.scale_above),
            ("loss.correctives[0]", weights.correctives[0]),
            ("loss.correctives[1]", weights.correctives[1]),
            ("loss.correctives[2]", weights.correctives[2]),
            ("perceptual.weight", self.perceptual.weight),
        ] {
            within(what, weight, 0.0..=1e6)?;
        }
        within("perceptual.every", self.perceptual.every, 1..=1_000_000)?;
        within("perceptual.window", self.perceptual.window, 32..=1024)?;
        within(
            "perceptual.from_share",
            self.perceptual.from_share,
            share.clone(),
        )?;
        let rates = &self.rates;
        for (what, found) in [
            ("rates.rotation", rates.rotation),
            ("rates.log_scale", rates.log_scale),
            ("rates.opacity", rates.opacity),
            ("rates.color", rates.color),
            ("rates.node_offset", rates.node_offset),
            ("rates.node_basis", rates.node_basis),
            ("rates.network", rates.network),
            ("rates.rotation_basis", rates.rotation_basis),
            ("rates.scale_basis", rates.scale_basis),
            ("rates.color_basis", rates.color_basis),
            ("rates.exposure", rates.exposure),
            ("rates.pose", rates.pose),
            ("rates.camera", rates.camera),
            ("rates.bone", rates.bone),
            ("rates.node_offset_end", rates.node_offset_end),
            ("rates.end", rates.end),
            ("rates.basis_end", rates.basis_end),
            ("rates.weight_decay", rates.weight_decay),
        ] {
            within(what, found, rate.clone())?;
        }
        within("prune.share", self.prune.share, share)?;
        within("prune.pictures", self.prune.pictures, 1..=100_000)?;
        within("data.band", self.data.band, 0..=32)?;
        within("data.window", self.data.window, 32..=2040)?;
        within("data.margin", self.data.margin, 0.0..=2.0)?;
        within("data.cache_mb", self.data.cache_mb, 0..=1_000_000)?;
        within("data.duplicate", self.data.duplicate, 0.0..=1.0)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn presets_are_read_and_written() {
        for preset in Preset::ALL {
            let recipe = Recipe::parse(preset.text()).unwrap();
            assert_eq!(Recipe::parse(&recipe.text()).unwrap(), recipe);
        }
    }

    #[test]
    fn unknown_and_missing_keys_and_wild_numbers_are_refused() {
        let text = Preset::Paper.text();
        let error = |text: String| Recipe::parse(&text).unwrap_err();
        let unknown = error(text.replace("batch = ", "batches = 4\nbatch = "));
        assert!(unknown.contains("batches"), "{unknown}");
        let missing = error(text.replace("batch = ", "# batch = "));
        assert!(missing.contains("batch"), "{missing}");
        let wild = error(text.replace("batch = 4", "batch = 0"));
        assert!(
            wild.contains("schedule.batch is 0, expected 1 to 64"),
            "{wild}"
        );
        let nan = error(text.replace("l1 = 1.0", "l1 = nan"));
        assert!(nan.contains("loss.l1"), "{nan}");
    }

    #[test]
    fn rates_fall_to_what_is_left_of_them() {
        let rates = Preset::Paper.recipe().rates;
        let end = rates.at(1.0);
        assert_eq!(rates.at(0.0).color, rates.color);
        assert!((end.color - rates.end * rates.color).abs() < 1e-12);
        assert!((end.node_offset - rates.node_offset_end * rates.node_offset).abs() < 1e-12);
    }
}
