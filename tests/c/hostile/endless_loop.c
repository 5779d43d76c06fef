/* A loop without end. Costs processor time, never hangs the simulator. */
// ends: running
int main(void)
{
    for (;;)
        ;
}
