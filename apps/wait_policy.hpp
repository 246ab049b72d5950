#pragma once

namespace seiche::apps {

/// Has OpenMP's threads sleep while they wait for each other, unless the user chose otherwise. On a busy machine
/// spinning ones are ten times slower. libgomp reads OMP_WAIT_POLICY when it is loaded, so the program starts itself
/// anew with it set; call this first in main().
void choose_passive_waiting(char** arguments);

}  // namespace seiche::apps
