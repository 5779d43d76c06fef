/* Files of the host outside the program's directory are never read. */
#include "/etc/hostname" // error: /etc/hostname

int main(void)
{
    return 0;
}
