/* Nor one that is reached by climbing up. */
#include "../../../../../../../../../../etc/hostname" // error: hostname

int main(void)
{
    return 0;
}
