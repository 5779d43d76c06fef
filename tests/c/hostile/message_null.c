/* No message at all. */
// ends: null pointer
#include <crs_request.h>

int main(void)
{
    return __crs_request(CRS_CLOCK, 0);
}
