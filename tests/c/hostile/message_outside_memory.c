/* A message that lies partly behind the end of memory. */
// ends: pointer outside memory
#include <crs_request.h>

int main(void)
{
    unsigned address;

    for (address = 0xFFFFFF00u; address > 0x1000; address -= 4096)
        __crs_request(CRS_GS, (struct __crs_message *) address);
    return 0;
}
