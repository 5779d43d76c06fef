/* The old name of <stdlib.h>. */
#include <stdlib.h>
