//! The system's own readings: sensors, clocks and the battery from `/sys`, where it has them and lets them be read; on Android headroom too.

use super::Reading;
use crate::measure::android::Thermal;
use std::{
    fs,
    path::{Path, PathBuf},
};

/// How far ahead Android is asked to look, seconds.
const AHEAD: i32 = 10;

/// Files that are there.
pub struct System {
    thermal: Option<Thermal>,
    sensors: Vec<PathBuf>,
    /// Current and highest clock of each core.
    clocks: Vec<[PathBuf; 2]>,
    battery: Option<PathBuf>,
}

impl System {
    pub fn new() -> Self {
        Self::at(Path::new("/sys"), Thermal::open())
    }

    /// The same of another root than `/sys`.
    pub fn at(root: &Path, thermal: Option<Thermal>) -> Self {
        let sensors = entries(&root.join("class/thermal"), "thermal_zone").map(|zone| zone.join("temp"));
        let cores = entries(&root.join("devices/system/cpu"), "cpu").map(|core| core.join("cpufreq"));
        let clocks = cores.map(|core| ["scaling_cur_freq", "cpuinfo_max_freq"].map(|name| core.join(name)));
        let battery = entries(&root.join("class/power_supply"), "").find(|supply| number(&supply.join("capacity")).is_some());
        Self {
            thermal,
            sensors: sensors.filter(|file| number(file).is_some()).collect(),
            clocks: clocks.filter(|files| files.iter().all(|file| number(file).is_some_and(|clock| clock > 0.0))).collect(),
            battery,
        }
    }

    pub fn read(&mut self) -> Reading {
        // Sensors that are switched off say 0 or less.
        let celsius = self.sensors.iter().filter_map(|file| number(file)).map(|milli| milli / 1e3).filter(|celsius| *celsius > 0.0);
        let shares: Vec<f64> = self.clocks.iter().filter_map(|[now, most]| Some(number(now)? / number(most)?)).collect();
        let battery = |name: &str| self.battery.as_ref().and_then(|folder| number(&folder.join(name)));
        // Microamperes and microvolts; the sign says which way, and not on all systems the same.
        let watts = battery("current_now").zip(battery("voltage_now")).map(|(current, voltage)| (current * voltage).abs() * 1e-12);
        Reading {
            headroom: self.thermal.as_ref().and_then(|thermal| thermal.headroom(AHEAD)),
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

/// What of a folder begins with a name, in order. Nothing of a folder that can't be read.
fn entries(folder: &Path, name: &str) -> impl Iterator<Item = PathBuf> + use<> {
    let all = fs::read_dir(folder).into_iter().flatten().flatten();
    let mut found: Vec<_> = all.filter(|entry| entry.file_name().to_string_lossy().starts_with(name)).map(|entry| entry.path()).collect();
    found.sort();
    found.into_iter()
}

fn number(file: &Path) -> Option<f64> {
    fs::read_to_string(file).ok()?.trim().parse().ok()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn sensors_clocks_and_battery_are_read_and_what_is_missing_is_not() -> std::io::Result<()> {
        let root = tempfile::tempdir()?;
        assert_eq!(System::at(root.path(), None).read(), Reading::default());
        let files = [
            ("class/thermal/thermal_zone0/temp", "41500\n"),
            ("class/thermal/thermal_zone1/temp", "-274000\n"),
            ("class/thermal/cooling_device0/temp", "99000\n"),
            ("devices/system/cpu/cpu0/cpufreq/scaling_cur_freq", "1500000"),
            ("devices/system/cpu/cpu0/cpufreq/cpuinfo_max_freq", "3000000"),
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
        assert_eq!((read.celsius, read.clock, read.battery, read.watts), (Some(41.5), Some(0.5), Some(0.8), Some(6.0)));
        Ok(())
    }
}
