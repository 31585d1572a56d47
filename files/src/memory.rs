//! Memory that this process can still take.

use std::fs;
use std::sync::OnceLock;

static LIMIT: OnceLock<u64> = OnceLock::new();

/// Lets this process take no more than so many bytes in all, as far as it asks before it takes them; the first limit
/// stays.
pub fn limit_memory(bytes: u64) {
    let _ = LIMIT.set(bytes);
}

/// The limit of [`limit_memory`].
pub fn memory_limit() -> Option<u64> {
    LIMIT.get().copied()
}

/// Bytes that are free for this process: of the machine, of the control group that holds it, of its own limits; none
/// if the system tells nothing of it.
pub fn free_memory() -> Option<u64> {
    let read = |path: &str| fs::read_to_string(path).ok();
    let machine = read("/proc/meminfo").and_then(|text| {
        let kib = field(&text, "MemAvailable:")? + field(&text, "SwapFree:").unwrap_or(0);
        Some(kib << 10)
    });
    let group = read("/sys/fs/cgroup/memory.max").and_then(|most| {
        let most: u64 = most.trim().parse().ok()?;
        let taken = field(&read("/sys/fs/cgroup/memory.stat")?, "anon")?;
        Some(most.saturating_sub(taken))
    });
    let own = read("/proc/self/limits").and_then(|limits| {
        let most = field(&limits, "Max address space")?;
        let taken = field(&read("/proc/self/status")?, "VmSize:")? << 10;
        Some(most.saturating_sub(taken))
    });
    let limit = LIMIT.get().map(|limit| {
        let taken = read("/proc/self/status").and_then(|status| field(&status, "VmRSS:"));
        limit.saturating_sub(taken.unwrap_or(0) << 10)
    });
    [machine, group, own, limit].into_iter().flatten().min()
}

/// The number that follows a name at the beginning of a line.
pub fn field(text: &str, name: &str) -> Option<u64> {
    let rest = text.lines().find_map(|line| line.strip_prefix(name))?;
    rest.split_whitespace().next()?.parse().ok()
}
