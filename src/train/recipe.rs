//! Every weight, rate and count of a training, in one TOML file.

use crate::adam::{Adam, Rates};
use crate::data::DataOptions;
use crate::loss::LossWeights;
use crate::refine::RefineRates;
use crate::start::Sizes;
use effigy_core::avatar::Filter;
use serde::{Deserialize, Serialize};
use std::fmt::Display;
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
    pub schedule: TrainingSchedule,
    /// Weights of the losses.
    pub loss: LossWeights,
    /// The perceptual loss.
    pub perceptual: PerceptualOptions,
    /// Learning rates.
    pub rates: RateOptions,
    /// Which basis rows stay.
    pub prune: PruneOptions,
    /// From where Gaussians are drawn.
    pub facing: FacingOptions,
    /// How pictures become views.
    pub data: DataOptions,
}

/// How long a training takes.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields, rename = "Schedule")]
pub struct TrainingSchedule {
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

/// The perceptual loss.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct PerceptualOptions {
    /// Which loss.
    pub kind: PerceptualKind,
    /// Its weight.
    pub weight: f64,
    /// Steps from one that has it to the next. Its weight there is as many times as large, which
    /// makes Adam careful: prefer a small part often to a large one seldom.
    pub every: u64,
    /// Side of the part of a view that it sees, px.
    pub window: u32,
    /// Steps before the first that has it, of those before pruning.
    pub from_share: f64,
}

/// A perceptual loss.
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

/// Learning rates: Adam's at the start of the training.
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
    /// Share of the nodes' offsets' rate that is left at the end.
    pub node_offset_end: f64,
    /// Share of the other rates that is left at the end, except those of basis rows.
    pub end: f64,
    /// Share of the rates of basis rows that is left at the end.
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
    /// Share of the Gaussians that keep a row, for each attribute.
    pub share: f64,
    /// Pictures used by [`PruneBy::Pictures`].
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

/// From where Gaussians are drawn: what never shows from a side is left out there.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct FacingOptions {
    /// Steps before it is found, of all.
    pub from_share: f64,
    /// What a Gaussian is of a pixel at least where it shows, 255ths. The more, the fewer are drawn,
    /// and the more the training has to make up for.
    pub shown: f64,
    /// How often it is found, evenly spaced over the other steps; 0: all are drawn from everywhere.
    pub times: u64,
}

impl FacingOptions {
    /// How often it has been found when a share of the training is over.
    pub fn times_at(&self, share: f64) -> u64 {
        if share < self.from_share {
            return 0;
        }
        let rest = (share - self.from_share) / (1.0 - self.from_share).max(1e-9);
        ((rest * self.times as f64) as u64 + 1).min(self.times)
    }
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

    /// Its file, which explains every key.
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

    /// Checks that every number is within its range.
    fn check(&self) -> Result<(), String> {
        /// Rows of a key and its range.
        macro_rules! within {
            ($($section:ident.$key:ident $([$at:literal])? in $range:expr;)*) => {
                $(within(
                    concat!(stringify!($section), ".", stringify!($key) $(, "[", $at, "]")?),
                    self.$section.$key $([$at])?,
                    $range,
                )?;)*
            };
        }
        within! {
            sizes.gaussians in 16..=1_000_000;
            sizes.parts in 1..=1024;
            sizes.nodes in 3..=65_536;
            sizes.hidden in 1..=128;
            sizes.head_density in 0.1..=100.0;
            sizes.opacity in 0.01..=0.99;
            sizes.thickness in 0.01..=1.0;
            filter.variance in Filter::VARIANCES;
            schedule.iterations in 1..=100_000_000;
            schedule.fine_tune in 0..=100_000_000;
            schedule.batch in 1..=64;
            schedule.neutral_share in SHARE;
            schedule.refine_share in SHARE;
            loss.l1 in WEIGHT;
            loss.scale in WEIGHT;
            loss.scale_above in WEIGHT;
            loss.correctives[0] in WEIGHT;
            loss.correctives[1] in WEIGHT;
            loss.correctives[2] in WEIGHT;
            perceptual.weight in WEIGHT;
            perceptual.every in 1..=1_000_000;
            perceptual.window in 32..=1024;
            perceptual.from_share in SHARE;
            rates.rotation in RATE;
            rates.log_scale in RATE;
            rates.opacity in RATE;
            rates.color in RATE;
            rates.node_offset in RATE;
            rates.node_basis in RATE;
            rates.network in RATE;
            rates.rotation_basis in RATE;
            rates.scale_basis in RATE;
            rates.color_basis in RATE;
            rates.exposure in RATE;
            rates.pose in RATE;
            rates.camera in RATE;
            rates.bone in RATE;
            rates.node_offset_end in SHARE;
            rates.end in SHARE;
            rates.basis_end in SHARE;
            rates.weight_decay in RATE;
            prune.share in SHARE;
            prune.pictures in 1..=100_000;
            facing.from_share in SHARE;
            facing.shown in 1.0..=255.0;
            facing.times in 0..=100;
            data.band in 0..=32;
            data.window in 32..=2040;
            data.margin in 0.0..=2.0;
            data.cache_mb in 0..=1_000_000;
            data.duplicate in 0.0..=1.0;
        }
        Ok(())
    }
}

const SHARE: RangeInclusive<f64> = 0.0..=1.0;
const RATE: RangeInclusive<f64> = 0.0..=1.0;
const WEIGHT: RangeInclusive<f64> = 0.0..=1e6;

fn within<T: PartialOrd + Display>(
    key: &str,
    found: T,
    range: RangeInclusive<T>,
) -> Result<(), String> {
    if range.contains(&found) {
        return Ok(());
    }
    let [low, high] = [range.start(), range.end()];
    Err(format!("{key} is {found}, expected {low} to {high}"))
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
