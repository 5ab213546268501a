//! The covariance of a few numbers over many poses.

/// Mean and covariance of N numbers over poses that arrive one after another (Welford's method).
pub struct RunningCovariance {
    count: f64,
    mean: Vec<f64>,
    /// Sums of products of deviations, shape N, N.
    products: Vec<f64>,
}

impl RunningCovariance {
    /// Of no pose yet.
    pub fn new(n: usize) -> Self {
        Self {
            count: 0.0,
            mean: vec![0.0; n],
            products: vec![0.0; n * n],
        }
    }

    /// Adds the numbers of a pose.
    pub fn add(&mut self, x: &[impl Copy + Into<f64>]) {
        self.count += 1.0;
        let n = self.mean.len();
        // Deviations from the old mean; from the new one in `after`.
        let before: Vec<f64> = x
            .iter()
            .zip(&self.mean)
            .map(|(&x, mean)| x.into() - mean)
            .collect();
        for (mean, deviation) in self.mean.iter_mut().zip(&before) {
            *mean += deviation / self.count;
        }
        for (i, &x) in x.iter().enumerate() {
            let after = x.into() - self.mean[i];
            let row = &mut self.products[i * n..][..n];
            for (sum, before) in row.iter_mut().zip(&before) {
                *sum += after * before;
            }
        }
    }

    /// Length N.
    pub fn mean(&self) -> &[f64] {
        &self.mean
    }

    /// Shape N, N.
    pub fn covariance(&self) -> Vec<f64> {
        self.products
            .iter()
            .map(|p| p / self.count.max(1.0))
            .collect()
    }
}
