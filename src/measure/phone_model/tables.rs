//! The model as tables of Markdown.

use super::{PhoneModel, Range, estimate::StageEstimate, inputs::Counted};

/// The line before the tables in a page.
pub const BEGIN: &str = "<!-- tables of `effigy phone-model`: begin -->";
/// The line after them.
pub const END: &str = "<!-- tables of `effigy phone-model`: end -->";

/// A page with other tables between [`BEGIN`] and [`END`]. None where it has no place for them.
pub fn replace_tables(page: &str, tables: &str) -> Option<String> {
    let (before, rest) = page.split_once(BEGIN)?;
    let (_, after) = rest.split_once(END)?;
    Some(format!("{before}{BEGIN}\n\n{tables}\n{END}{after}"))
}

impl PhoneModel {
    /// The tables: frames, stages by way to draw, counts, and rates with their sources.
    pub fn tables(&self) -> String {
        let mut text = String::new();
        self.frame_table(&mut text);
        for counted in &self.inputs.counted {
            self.stage_table(&mut text, counted);
        }
        self.count_table(&mut text);
        self.rate_table(&mut text);
        text
    }

    fn device_names(&self) -> Vec<String> {
        let devices = self.inputs.devices.iter();
        devices.map(|device| device.device.clone()).collect()
    }

    fn frame_table(&self, text: &mut String) {
        *text += "### Frames, ms\n\n";
        head(text, "", &self.device_names());
        for counted in &self.inputs.counted {
            let frames = self.frames_of(counted);
            let cells = frames.map(|frame| milliseconds(frame.ms()));
            row(text, counted.name, cells);
        }
    }

    fn frames_of<'a>(
        &'a self,
        counted: &'a Counted,
    ) -> impl Iterator<Item = &'a super::FrameEstimate> {
        self.frames
            .iter()
            .filter(|frame| frame.method == counted.name)
    }

    fn stage_table(&self, text: &mut String, counted: &Counted) {
        *text += &format!("\n### {}, ms and what bounds it\n\n", upper(counted.name));
        head(text, "stage", &self.device_names());
        for stage in counted.stages() {
            let of_device = |frame: &super::FrameEstimate| {
                let own = frame.stages.iter().find(|own| own.stage == stage.name);
                own.map_or("–".to_owned(), cell)
            };
            row(text, &stage.name, self.frames_of(counted).map(of_device));
        }
    }

    fn count_table(&self, text: &mut String) {
        *text += "\n### Counts of a frame\n\n";
        let methods: Vec<String> = self
            .inputs
            .counted
            .iter()
            .map(|counted| counted.name.to_owned())
            .collect();
        head(text, "", &methods);
        for name in ["gaussians", "drawn", "fragments", "samples", "dispatches"] {
            let cells = self.inputs.counted.iter().map(|counted| {
                let count = counted.counter(name).ok();
                count.map_or("–".to_owned(), large)
            });
            row(text, name, cells);
        }
        let bytes = self.inputs.counted.iter().map(|counted| {
            let bytes = counted.case.bytes;
            bytes.map_or("–".to_owned(), |bytes| large(bytes as f64))
        });
        row(text, "bytes", bytes);
    }

    fn rate_table(&self, text: &mut String) {
        *text += "\n### Rates\n\n";
        *text += "| device | rate | from | to | | source |\n|---|---|---|---|---|---|\n";
        for rate in &self.inputs.rates {
            *text += &format!(
                "| {} | {} | {} | {} | {} | {} |\n",
                rate.device, rate.rate, rate.low, rate.high, rate.unit, rate.source
            );
        }
        for device in &self.inputs.devices {
            if !device.why.is_empty() {
                *text += &format!(
                    "\nInstructions of {} ({}) are those of {}: {}.\n",
                    device.device, device.chip, device.compiled_as, device.why
                );
            }
        }
    }
}

fn head(text: &mut String, first: &str, names: &[String]) {
    *text += &format!("| {first} | {} |\n", names.join(" | "));
    *text += &format!("|---|{}\n", "---|".repeat(names.len()));
}

fn row(text: &mut String, first: &str, cells: impl Iterator<Item = String>) {
    let cells: Vec<String> = cells.collect();
    *text += &format!("| {first} | {} |\n", cells.join(" | "));
}

fn cell(stage: &StageEstimate) -> String {
    let limits: Vec<&str> = stage
        .limits()
        .into_iter()
        .map(|limit| limit.name())
        .collect();
    let least = if stage.floor_only { "≥ " } else { "" };
    format!(
        "{least}{}, {}",
        milliseconds(stage.ms()),
        limits.join(" or ")
    )
}

/// A range of times with two digits that count; one number where both are the same.
fn milliseconds(range: Range) -> String {
    let (low, high) = (figure(range.low), figure(range.high));
    if low == high {
        low
    } else {
        format!("{low} – {high}")
    }
}

fn figure(number: f64) -> String {
    let digits = match number {
        _ if number >= 10.0 => 0,
        _ if number >= 1.0 => 1,
        _ if number >= 0.1 => 2,
        _ => 3,
    };
    format!("{number:.digits$}")
}

/// A count in thousands or millions.
fn large(count: f64) -> String {
    match count {
        _ if count >= 1e6 => format!("{:.2} M", count / 1e6),
        _ if count >= 1e4 => format!("{:.0} K", count / 1e3),
        _ => format!("{count:.0}"),
    }
}

fn upper(text: &str) -> String {
    let mut letters = text.chars();
    letters.next().map_or(String::new(), |first| {
        first.to_uppercase().chain(letters).collect()
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn tables_go_between_their_lines() {
        let page = format!("a\n{BEGIN}\nold\n{END}\nb\n");
        let new = replace_tables(&page, "new\n").expect("there is a place");
        assert_eq!(new, format!("a\n{BEGIN}\n\nnew\n\n{END}\nb\n"));
        assert_eq!(replace_tables(&new, "new\n").as_deref(), Some(new.as_str()));
        assert_eq!(replace_tables("a", "new"), None);
    }
}
