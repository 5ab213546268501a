//! Numerical stability: a seed and numbers of cases go in, the results of drawing each come out.
//!
//! Each case is an avatar, a pose, a camera and options that are hard to draw ([`Category`] says
//! how). The device and the f64 reference draw it. No pixel may be NaN or out of range, drawing the
//! frame again must give equal bits, nothing may hang, validation must stay silent, and every pixel
//! must be within its bound ([`ImageBound`]) of the reference's image of the model as device memory
//! holds it, computed from the model and, where a case allows it, from the pose cache. A case
//! follows from the seed and its number alone.
//!
//! A `draft` of a `body` is made hard by `adversarial`, becomes a `case`, some of them `small`, and
//! is drawn and compared by `check`, with the bounds of `bound`; broken inputs are tried by
//! `refusal`.

mod adversarial;
mod body;
mod bound;
mod case;
mod category;
mod check;
mod draft;
#[cfg(test)]
mod faults;
mod refusal;
mod report;
mod run;
mod small;

pub use bound::{BoundScene, BoundUse, ImageBound, Rounding};
pub use case::{Rasterizer, StressCase};
pub use category::Category;
pub use check::{CaseOutcome, check_case};
pub use report::{CategoryReport, Failure, RasterizerReport, StressCaseReport, StressReport};
pub use run::{StressSettings, run};
