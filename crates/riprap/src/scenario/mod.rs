//! What the user said: the TOML scenario with units and spans. No physics, no hidden defaults.
