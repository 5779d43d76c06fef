/* GNU features.h: everything is declared, whatever is asked for. */
#ifndef _FEATURES_H
#define _FEATURES_H

#include <sys/cdefs.h>

#endif
