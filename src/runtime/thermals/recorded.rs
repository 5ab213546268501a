//! Headroom that a soak recorded: its CSV goes in, readings at any time come out.

/// A line of the CSV.
#[derive(Clone, Copy, Debug, PartialEq)]
struct RecordedReading {
    seconds: f64,
    headroom: f64,
}

/// Readings of headroom in the order of their times, at least one.
#[derive(Clone, Debug, PartialEq)]
pub struct Recorded(Vec<RecordedReading>);

impl Recorded {
    /// Reads the columns `seconds` and `headroom` of a soak's CSV. Lines without headroom are
    /// skipped.
    ///
    /// # Errors
    /// When a column is missing, a cell isn't a number, or no line has headroom.
    pub fn read(text: &str) -> Result<Self, String> {
        let mut reader = csv::Reader::from_reader(text.as_bytes());
        let headers = reader
            .headers()
            .map_err(|error| format!("it is not comma-separated: {error}"))?
            .clone();
        let column = |name: &str| {
            let found = headers.iter().position(|header| header == name);
            found.ok_or_else(|| format!("it has no column `{name}`, as the CSV of a soak has"))
        };
        let seconds_column = column("seconds")?;
        let headroom_column = column("headroom")?;
        let mut readings = Vec::new();
        for (number, line) in reader.records().enumerate() {
            let line = line.map_err(|error| error.to_string())?;
            let headroom = line.get(headroom_column).unwrap_or_default();
            if headroom.is_empty() {
                continue;
            }
            let parse = |text: &str| {
                text.parse::<f64>()
                    .map_err(|_| format!("line {} has `{text}`, expected a number", number + 2))
            };
            readings.push(RecordedReading {
                seconds: parse(line.get(seconds_column).unwrap_or_default())?,
                headroom: parse(headroom)?,
            });
        }
        if readings.is_empty() {
            return Err("it has no reading of headroom".into());
        }
        readings.sort_by(|a, b| a.seconds.total_cmp(&b.seconds));
        Ok(Self(readings))
    }

    /// The last headroom read up to a time, seconds; before the first reading, that one.
    pub fn at(&self, seconds: f64) -> Option<f64> {
        let after = self.0.partition_point(|reading| reading.seconds <= seconds);
        let last = self.0.get(after.saturating_sub(1))?;
        Some(last.headroom)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_soaks_csv_is_read_and_others_are_refused() {
        let read = Recorded::read("seconds,fps,headroom\n1,60,0.5\n2,60,\n3,59,0.75\n")
            .unwrap_or(Recorded(vec![]));
        assert_eq!(
            [0.0, 1.5, 2.9, 3.0, 99.0].map(|at| read.at(at)),
            [0.5, 0.5, 0.5, 0.75, 0.75].map(Some)
        );
        assert!(Recorded::read("a,b\n1,2\n").is_err_and(|error| error.contains("`seconds`")));
        assert!(
            Recorded::read("seconds,headroom\n1,hot\n")
                .is_err_and(|error| error.contains("line 2"))
        );
        assert!(Recorded::read("seconds,headroom\n1,\n").is_err());
    }
}
