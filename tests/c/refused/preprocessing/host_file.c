/* A file of the host outside the program's folder is never read. */
#include "/etc/hostname" // error: /etc/hostname

int main(void)
{
    return 0;
}
