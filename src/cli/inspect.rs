//! `effigy inspect`: a file goes in; what it holds comes out as text for people or JSON for programs.

mod avatar;
mod motion;

use crate::avatar::{
    file::{Content, TensorInfo, format::Order, tensors},
    import,
};
use anyhow::Context;
use serde::Serialize;
use std::fmt;
use std::io::{self, Write};
use std::path::PathBuf;

#[derive(clap::Args)]
pub struct Args {
    /// An avatar or motion file, or a 3DGS .ply [default: the built-in demo avatar]
    file: Option<PathBuf>,
    /// Print JSON
    #[arg(long)]
    json: bool,
}

pub fn run(args: Args) -> anyhow::Result<()> {
    let content = match &args.file {
        Some(file) if import::is_ply(file) => Content::Avatar(Box::new(import::open(file, None)?)),
        Some(file) => Content::read(file)?,
        None => Content::Avatar(Box::new(crate::demo::avatar()?)),
    };
    let stored = match &args.file {
        Some(file) if !import::is_ply(file) => Some(tensors(file)?),
        _ => None,
    };
    match content {
        Content::Avatar(avatar) => print(&avatar::Summary::new(&avatar, stored.unwrap_or_else(|| avatar.tensors())), args.json),
        Content::Clip(clip) => print(&motion::Summary::new(&clip), args.json),
    }
}

fn print(summary: &(impl Serialize + fmt::Display), json: bool) -> anyhow::Result<()> {
    // Names come from the file: control characters in them could do anything to a terminal.
    let plain = |c: char| if c.is_control() && c != '\n' { ' ' } else { c };
    let text = if json { serde_json::to_string_pretty(summary)? } else { summary.to_string().chars().map(plain).collect() };
    match writeln!(io::stdout().lock(), "{}", text.trim_end()) {
        // A reader such as `head` that has seen enough is no failure.
        Err(error) if error.kind() == io::ErrorKind::BrokenPipe => Ok(()),
        outcome => outcome.context("cannot print"),
    }
}

/// Smallest, middle and largest of some numbers.
#[derive(Debug, PartialEq, Serialize)]
struct Spread {
    min: f64,
    median: f64,
    max: f64,
}

impl Spread {
    fn of(numbers: impl IntoIterator<Item = f64>) -> Self {
        let mut sorted: Vec<f64> = numbers.into_iter().collect();
        sorted.sort_by(f64::total_cmp);
        let at = |k: usize| sorted.get(k).copied().unwrap_or(0.0);
        Self { min: at(0), median: at(sorted.len() / 2), max: at(sorted.len().saturating_sub(1)) }
    }
}

/// A count with its thousands apart: 200,000.
fn thousands(n: usize) -> String {
    let digits = n.to_string();
    let group = |(k, c): (usize, char)| (k > 0 && (digits.len() - k).is_multiple_of(3)).then_some(',').into_iter().chain([c]);
    digits.chars().enumerate().flat_map(group).collect()
}

/// A heading and what it is of, in two columns.
fn line(f: &mut fmt::Formatter, heading: &str, text: impl fmt::Display) -> fmt::Result {
    writeln!(f, "{heading:<11} {text}")
}

/// The tensors of a file and their sum.
fn table(f: &mut fmt::Formatter, tensors: &[TensorInfo]) -> fmt::Result {
    writeln!(f, "\n{:<26} {:<5} {:<18} {:>12} {:>12}", "tensor", "type", "shape", "bytes", "in the file")?;
    for tensor in tensors {
        let shape = tensor.shape.iter().map(usize::to_string).collect::<Vec<_>>().join(" × ");
        let [bytes, stored] = [tensor.bytes, tensor.stored].map(thousands);
        let how = match tensor.deflated {
            None => "",
            Some(Order::Planes) => ", deflated",
            Some(Order::Deltas) => ", differences deflated",
        };
        writeln!(f, "{:<26} {:<5} {shape:<18} {bytes:>12} {stored:>12}  {}{how}", tensor.name, tensor.dtype, tensor.what)?;
    }
    let sum = |of: fn(&TensorInfo) -> usize| thousands(tensors.iter().map(of).sum());
    writeln!(f, "{:<51} {:>12} {:>12}", "sum", sum(|tensor| tensor.bytes), sum(|tensor| tensor.stored))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn thousands_stand_apart() {
        assert_eq!([0, 12, 123, 1234, 123_456, 1_234_567].map(thousands), ["0", "12", "123", "1,234", "123,456", "1,234,567"]);
    }

    #[test]
    fn a_spread_orders_its_numbers() {
        assert_eq!(Spread::of([3.0, -1.0, 2.0]), Spread { min: -1.0, median: 2.0, max: 3.0 });
    }
}
