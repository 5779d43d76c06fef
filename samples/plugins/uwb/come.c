/* Drives ahead for four seconds. */
#include <unistd.h>
#include "Nclient.h"

int main(void)
{
    connect_robot(1);
    scout_vm(100, 0);
    sleep(4);
    st();
    return 0;
}
