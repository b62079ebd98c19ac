#![no_main]
riprap_fuzz_guided::guided!();
