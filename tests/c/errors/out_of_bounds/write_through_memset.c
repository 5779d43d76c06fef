/* An array is cleared with the size of another. */
#include <string.h>

int main(void)
{
    short small[8];
    int large[8];

    memset(large, 0, sizeof large);
    memset(small, 0, sizeof large); // error: out of bounds
    return large[0];
}
