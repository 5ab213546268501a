//! The system's own readings: sensors, clocks and the battery from `/sys`, where they exist and may
//! be read; on Android headroom too.

use super::reading::ThermalReading;
use crate::ndk::Thermal;
use std::{
    fs,
    path::{Path, PathBuf},
};

/// How far ahead Android's headroom looks, seconds.
const AHEAD: i32 = 10;

/// The files of a core's clock.
struct ClockFiles {
    current: PathBuf,
    highest: PathBuf,
}

/// The sensors that this system has.
pub struct System {
    thermal: Option<Thermal>,
    sensors: Vec<PathBuf>,
    clocks: Vec<ClockFiles>,
    /// Folder of the battery.
    battery: Option<PathBuf>,
}

impl System {
    /// Looks for sensors under `/sys`, and for Android's thermal service.
    pub fn new() -> Self {
        Self::at(Path::new("/sys"), Thermal::open())
    }

    /// Looks for sensors under another root than `/sys`.
    pub fn at(root: &Path, thermal: Option<Thermal>) -> Self {
        let sensors =
            entries(&root.join("class/thermal"), "thermal_zone").map(|zone| zone.join("temp"));
        let cores =
            entries(&root.join("devices/system/cpu"), "cpu").map(|core| core.join("cpufreq"));
        let clocks = cores.map(|core| ClockFiles {
            current: core.join("scaling_cur_freq"),
            highest: core.join("cpuinfo_max_freq"),
        });
        let is_clock = |file: &Path| number(file).is_some_and(|clock| clock > 0.0);
        let battery = entries(&root.join("class/power_supply"), "")
            .find(|supply| number(&supply.join("capacity")).is_some());
        Self {
            thermal,
            sensors: sensors.filter(|file| number(file).is_some()).collect(),
            clocks: clocks
                .filter(|files| is_clock(&files.current) && is_clock(&files.highest))
                .collect(),
            battery,
        }
    }

    /// The readings now.
    pub fn read(&mut self) -> ThermalReading {
        // Sensors that are switched off read 0 or less.
        let celsius = self
            .sensors
            .iter()
            .filter_map(|file| number(file))
            .map(|milli| milli / 1e3)
            .filter(|celsius| *celsius > 0.0);
        let shares: Vec<f64> = self
            .clocks
            .iter()
            .filter_map(|files| Some(number(&files.current)? / number(&files.highest)?))
            .collect();
        let battery = |name: &str| {
            self.battery
                .as_ref()
                .and_then(|folder| number(&folder.join(name)))
        };
        // Microamperes and microvolts. Systems differ in which sign of the current means charging.
        let watts = battery("current_now")
            .zip(battery("voltage_now"))
            .map(|(current, voltage)| (current * voltage).abs() * 1e-12);
        ThermalReading {
            headroom: self
                .thermal
                .as_ref()
                .and_then(|thermal| thermal.headroom(AHEAD)),
            celsius: celsius.reduce(f64::max),
            clock: (!shares.is_empty()).then(|| shares.iter().sum::<f64>() / shares.len() as f64),
            battery: battery("capacity").map(|percent| percent / 100.0),
            watts,
        }
    }
}

impl Default for System {
    fn default() -> Self {
        Self::new()
    }
}

/// The entries of a folder whose names begin with `prefix`, in order. None of a folder that can't
/// be read.
fn entries(folder: &Path, prefix: &str) -> impl Iterator<Item = PathBuf> + use<> {
    let all = fs::read_dir(folder).into_iter().flatten().flatten();
    let mut found: Vec<_> = all
        .filter(|entry| entry.file_name().to_string_lossy().starts_with(prefix))
        .map(|entry| entry.path())
        .collect();
    found.sort();
    found.into_iter()
}

/// The number that a file consists of.
fn number(file: &Path) -> Option<f64> {
    fs::read_to_string(file).ok()?.trim().parse().ok()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn existing_sensors_are_read_and_missing_ones_are_none() -> std::io::Result<()> {
        let root = tempfile::tempdir()?;
        assert_eq!(
            System::at(root.path(), None).read(),
            ThermalReading::default()
        );
        let files = [
            ("class/thermal/thermal_zone0/temp", "41500\n"),
            ("class/thermal/thermal_zone1/temp", "-274000\n"),
            ("class/thermal/cooling_device0/temp", "99000\n"),
            (
                "devices/system/cpu/cpu0/cpufreq/scaling_cur_freq",
                "1500000",
            ),
            (
                "devices/system/cpu/cpu0/cpufreq/cpuinfo_max_freq",
                "3000000",
            ),
            ("devices/system/cpu/cpu1/cpufreq/scaling_cur_freq", "secret"),
            ("class/power_supply/ac/online", "1"),
            ("class/power_supply/battery/capacity", "80"),
            ("class/power_supply/battery/current_now", "-1500000"),
            ("class/power_supply/battery/voltage_now", "4000000"),
        ];
        for (file, text) in files {
            let path = root.path().join(file);
            fs::create_dir_all(path.parent().unwrap_or(root.path()))?;
            fs::write(path, text)?;
        }
        let read = System::at(root.path(), None).read();
        assert_eq!(
            (read.celsius, read.clock, read.battery, read.watts),
            (Some(41.5), Some(0.5), Some(0.8), Some(6.0))
        );
        Ok(())
    }
}
