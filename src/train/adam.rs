//! How far a step goes.

/// Rates of Adam, one for each kind of number.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Rates {
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
    /// Of the basis rows of rotation, scale and colour.
    pub bases: [f64; 3],
}

/// Adam's constants.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Adam {
    /// β₁: how much of the first moment is kept.
    pub beta_1: f64,
    /// β₂: how much of the second.
    pub beta_2: f64,
    /// ε.
    pub epsilon: f64,
    /// Weight decay of the networks, apart from the derivative (AdamW).
    pub weight_decay: f64,
}

impl Adam {
    /// The predecessor's.
    pub const DEFAULT: Self = Self {
        beta_1: 0.9,
        beta_2: 0.999,
        epsilon: 1e-15,
        weight_decay: 1e-3,
    };

    /// 1 / (1 − β₁ᵗ) and 1 / (1 − β₂ᵗ) at the t-th step, the first of which is 1.
    pub fn correction(&self, t: u64) -> [f64; 2] {
        let power = i32::try_from(t.max(1)).unwrap_or(i32::MAX);
        [self.beta_1, self.beta_2].map(|beta| 1.0 / (1.0 - beta.powi(power)))
    }
}
